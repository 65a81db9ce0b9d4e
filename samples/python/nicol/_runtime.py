# SPDX-License-Identifier: MIT
"""Runtime of _abi.py: the shared library, errors, handles, structs and buffers."""

import ctypes
import ctypes.util
import itertools
import os
import re
import sys
from typing import Any, ClassVar


def _load():
    named = os.environ.get("NICOL_LIBRARY")
    packaged = os.path.join(os.path.dirname(__file__), "lib", "libnicol.so.0.1")
    for path in [named] if named else [packaged, ctypes.util.find_library("nicol"), "libnicol.so.0.1"]:
        try:
            if path:
                return ctypes.CDLL(path)
        except OSError as error:
            reason = error
    raise ImportError(
        f"libnicol was not found ({reason}); set NICOL_LIBRARY to the path of libnicol.so.0.1, or install it where "
        "the dynamic linker looks"
    )


library = _load()


def declare(name, result, *parameters):
    function = getattr(library, name)
    function.restype, function.argtypes = result, parameters
    return function


class Error(Exception):
    """A failure of the library; code is one of ERROR_..., the text states the valid values."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code

    def __reduce__(self):
        # By default the text alone is handed to __init__() where an error of a pool's worker is unpickled.
        return type(self), (self.code, str(self))


_raised: list[BaseException] = []  # exceptions of callbacks, which then return 0
_ended_by_callbacks = (4, 6, 9)  # results of a call whose callback returned 0
_last_error = declare("nicol_last_error", ctypes.c_char_p)


def check(result):
    """Raises the exception of a callback, or the library's error."""
    if result in _ended_by_callbacks and _raised:
        error = _raised[0]
        _raised.clear()
        raise error
    if result:
        raise Error(result, os.fsdecode(_last_error()))


def text(value):
    return None if value is None else os.fsencode(value)


def texts(values):
    encoded = [text(value) for value in values]
    return (ctypes.c_char_p * len(encoded))(*encoded)


class Handle(ctypes.c_void_p):
    """An object of the library. `with`, release(), or the end of its last reference in Python releases it; the library
    keeps everything that other objects need."""

    _release: ClassVar[Any]

    @classmethod
    def from_param(cls, value):
        if value is None or isinstance(value, cls):
            return value
        raise TypeError(f"a nicol.{cls.__name__} is wanted, not {value!r}")

    def release(self):
        if self.value:
            type(self)._release(self)
            self.value = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.release()

    def __del__(self):
        self.release()

    def __reduce__(self):
        raise TypeError(f"a nicol.{type(self).__name__} belongs to this process and cannot be pickled")

    def __repr__(self):
        return f"<nicol.{type(self).__name__} {hex(self.value) if self.value else 'released'}>"


def paired(structs, struct, handles, handle):
    """Returns an array of structs and one of as many handles."""
    if len(structs) != len(handles):
        raise ValueError(f"{len(structs)} of nicol.{struct.__name__} and {len(handles)} of nicol.{handle.__name__}; give as many")
    numbers = [getattr(handle.from_param(one), "value", None) for one in handles]
    # An array of handles would release those that are read from it.
    numbers = (ctypes.c_void_p * len(numbers))(*numbers)
    return (struct * len(structs))(*structs), ctypes.cast(numbers, ctypes.POINTER(handle))


class Callback:
    """A type of C function that a Python function can implement. The Python function is called without C's `user`; arrays
    arrive as arrays, strings as str. The return value None or True means to continue."""

    def __init__(self, result, *parameters):
        # Position and conversion of each parameter except void* user.
        self.seen = [(place, see) for place, (_, see) in enumerate(parameters) if see]
        self.result = result
        self.type = ctypes.CFUNCTYPE(result, *[type_ for type_, _ in parameters])

    def __call__(self, function):
        if function is None or isinstance(function, self.type):
            return function or self.type()

        def called(*arguments):
            try:
                answer = function(*[see(arguments[place]) for place, see in self.seen])
            except BaseException as error:
                if self.result is None:
                    raise
                _raised.append(error)
                return 0
            return None if self.result is None else int(answer is None or bool(answer))

        return self.type(called)


def as_is(value):
    return value


def pointee(value):
    return value.contents


def decoded(value):
    return None if value is None else os.fsdecode(value)


def flat(value):
    """Returns the numbers of a sequence, of nested rows, or of a numpy array as a list."""
    numbers = list(value)
    while numbers and hasattr(numbers[0], "__len__"):
        numbers = list(itertools.chain.from_iterable(numbers))
    return numbers


class Buffer:
    """Python's memory of C numbers: a numpy array, array.array, memoryview, or a sequence to copy. Input of the library
    is converted if it holds other numbers of the same kind or is not contiguous."""

    def __init__(self, value, type_, writable=False, rows=False):
        self.pointer, self.count, self.nbytes, self.stride = None, 0, 0, 0
        if value is None:
            return
        try:
            view = memoryview(value)
        except TypeError:
            if writable:
                raise TypeError(f"results need a writable buffer of {type_.__name__}, not {value!r}") from None
            value = flat(value)
            view = memoryview((type_ * len(value))(*value))
        if not writable:
            value, view = self._converted(value, view, type_)
        if view.format.lstrip("<=") != type_._type_:
            raise TypeError(f"a buffer of '{view.format}' where one of '{type_._type_}' ({type_.__name__}) is wanted")
        if writable and view.readonly:
            raise TypeError("results need a writable buffer")
        if not view.c_contiguous:
            if not rows or view.ndim < 2 or view.strides[0] < 0 or not view[:1].c_contiguous:
                raise TypeError("the buffer is not contiguous" + (" within its rows" if rows else ""))
            self.stride = view.strides[0]
        self.nbytes = self.stride * (view.shape[0] - 1) + view[:1].nbytes if self.stride else view.nbytes
        self.count = self.nbytes // view.itemsize
        if self.nbytes:
            self.owner = value if hasattr(value, "__array_interface__") else view
            self.pointer = ctypes.cast(self._address(), ctypes.POINTER(type_))

    @staticmethod
    def _converted(value, view, type_):
        kind, wanted = view.format.lstrip("<="), type_._type_
        whole = {kind, wanted} <= set("bBhHiIlLqQ")
        if not (whole or {kind, wanted} <= set("efd")) or (kind == wanted and view.c_contiguous):
            return value, view
        if hasattr(value, "astype"):
            copy = value.astype(type_, order="C")
            lost = whole and not (copy == value).all()
        else:
            numbers = flat(view.tolist())
            copy = (type_ * len(numbers))(*numbers)
            lost = whole and list(copy) != numbers
        if lost:
            raise ValueError(f"a number that {type_.__name__} cannot hold")
        return copy, memoryview(copy)

    def _address(self):
        if hasattr(self.owner, "__array_interface__"):
            return self.owner.__array_interface__["data"][0]
        block = ctypes.c_char * self.nbytes
        self.memory = block.from_buffer_copy(self.owner) if self.owner.readonly else block.from_buffer(self.owner)
        return ctypes.addressof(self.memory)


class Memory:
    """Python's memory of any numbers that the library writes to, or only reads."""

    def __init__(self, value, writable=True):
        view = memoryview(value)
        if view.strides[0] < 0 or not view[:1].c_contiguous:
            raise TypeError("the buffer is not contiguous within its rows")
        if writable and view.readonly:
            raise TypeError("results need a writable buffer")
        if hasattr(value, "__array_interface__"):
            self.owner, self.address = value, value.__array_interface__["data"][0]
        elif view.readonly:
            self.owner = (ctypes.c_char * view.nbytes).from_buffer_copy(value)
            self.address = ctypes.addressof(self.owner)
        else:
            self.owner = (ctypes.c_char * view.nbytes).from_buffer(value)
            self.address = ctypes.addressof(self.owner)


def counted(*buffers):
    """Returns the common count of buffers."""
    if len({buffer.count for buffer in buffers}) > 1:
        raise ValueError(f"buffers of {', '.join(str(buffer.count) for buffer in buffers)} values; they must agree")
    return buffers[0].count


def array(value, type_, count):
    """Returns a C array of this length from a sequence; nested rows and numpy arrays are flattened."""
    if value is None:
        return None
    numbers = flat(value)
    if len(numbers) != count:
        raise ValueError(f"{len(numbers)} numbers where {count} are wanted")
    return (type_ * count)(*numbers)


def words(name):
    """Returns the constants whose names begin with this name, by the rest of their names in lower case."""
    prefix = f"{name}_".upper()
    constants = vars(sys.modules[f"{__package__}._abi"])
    return {key[len(prefix) :].lower(): number for key, number in constants.items() if name and key.startswith(prefix)}


def constant(name, value, owner=""):
    """Returns the constant of a field, or of a struct where that gives the constants their names, by its word: "pixels" of
    the field shade_at is SHADE_AT_PIXELS. Returns other values, and those of fields without constants, as they are."""
    if not isinstance(value, str):
        return value
    known = words(name) or words(re.sub("(?<=[a-z])(?=[A-Z])", "_", owner))
    if known and value not in known:
        raise ValueError(f"{name} is '{value}'; it must be one of {', '.join(known)}")
    return known.get(value, value)


class Struct(ctypes.Structure):
    """A descriptor. Keywords set its fields, all other fields have their defaults. A spectrum accepts a number or one per
    channel. Pointers accept buffers and callbacks accept functions, both kept alive while they are in use."""

    _init: ClassVar[Any]
    _callbacks_: ClassVar[dict] = {}
    _read_only_: ClassVar[Any] = {}  # pointer fields whose memory the library only reads

    def __init__(self, **fields):
        super().__init__()
        object.__setattr__(self, "_kept", {})
        check(type(self)._init(ctypes.byref(self), ctypes.sizeof(self)))
        for name, value in fields.items():
            setattr(self, name, value)

    def __setattr__(self, name, value):
        types = type(self)._types_
        if name not in types:
            raise AttributeError(f"nicol.{type(self).__name__} has no field {name}; it has {', '.join(types)}")
        type_ = types[name]
        if name in self._callbacks_:
            self._kept[name] = value = self._callbacks_[name](value)
        elif isinstance(value, Handle):
            self._kept[name] = value
            value = value.value
        elif type_ is ctypes.c_char_p:
            value = text(value)
        elif isinstance(value, str):
            value = constant(name, value, type(self).__name__)
        elif type_ is ctypes.c_void_p and value is not None and not isinstance(value, int):
            self._kept[name] = memory = Memory(value, name not in self._read_only_)
            value = memory.address
        elif issubclass(type_, ctypes._Pointer):
            self._kept[name] = buffer = Buffer(value, type_._type_)
            value = buffer.pointer
        elif issubclass(type_, ctypes.Array) and not isinstance(value, type_):
            value = array(value, type_._type_, type_._length_)
        elif issubclass(type_, Struct) and not isinstance(value, type_):
            value = type_.of(value)
        super().__setattr__(name, value)

    def __getattribute__(self, name):
        value = super().__getattribute__(name)
        return os.fsdecode(value) if isinstance(value, bytes) else value

    def __init_subclass__(cls):
        super().__init_subclass__()
        cls._types_ = {name: type_ for name, type_ in cls._fields_}

    @classmethod
    def of(cls, value):
        """Returns a spectrum from a number or numbers."""
        if "values" not in cls._types_:
            raise TypeError(f"a nicol.{cls.__name__} is wanted, not {value!r}")
        values = list(value) if hasattr(value, "__len__") else [value]
        most = cls._types_["values"]._length_
        if len(values) > most:
            raise ValueError(f"a spectrum of {len(values)} values; at most {most} are possible")
        return cls(count=len(values), values=values + [0] * (most - len(values)))

    def __reduce__(self):
        fields = {}
        for name, type_ in self._types_.items():
            value = getattr(self, name)
            if type_ in (ctypes.c_char_p, ctypes.c_void_p) or issubclass(type_, (ctypes._Pointer, ctypes._CFuncPtr)):
                if value:
                    raise TypeError(f"{name} of a nicol.{type(self).__name__} belongs to this process and cannot be pickled")
            elif name != "struct_size":
                fields[name] = list(value) if isinstance(value, ctypes.Array) else value
        return _restored, (type(self), fields)

    def __repr__(self):
        fields = []
        for name in self._types_:
            value = getattr(self, name)
            fields.append(f"{name}={list(value) if isinstance(value, ctypes.Array) else value!r}")
        return f"nicol.{type(self).__name__}({', '.join(fields)})"


def _restored(type_, fields):
    return type_(**fields)


_lent: dict[int, list] = {}  # objects that the library still uses, by number
_numbers = itertools.count(1)


def _give_back(number):
    _lent.pop(number, None)


_give_back_callback = ctypes.CFUNCTYPE(None, ctypes.c_void_p)(_give_back)


_held: dict[tuple, Any] = {}  # functions that objects of the library call, by the object's address and the kind


def hold(handle, function):
    """Keeps a function that an object of the library calls from now on, until it is replaced by one of its kind."""
    _held[handle.value, type(function)] = function


def lend(struct):
    """Returns the struct for a call after which the library continues to use its buffers and functions. These live until
    the library calls `release`, which is set here, or forever if there is no such field."""
    if struct is not None and any(struct._kept.values()):
        number = next(_numbers)
        _lent[number] = list(struct._kept.values())
        if "release" in struct._types_:
            user = "release_user" if "release_user" in struct._types_ else "user"
            ctypes.Structure.__setattr__(struct, "release", _give_back_callback)
            ctypes.Structure.__setattr__(struct, user, number)
    return struct
