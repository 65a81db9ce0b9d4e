// SPDX-License-Identifier: MIT
// Tests of archives written by other programs: types, compression and every kind of fault.
#include <sys/resource.h>

#include "files/archive.hpp"
#include "files/npz.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr auto bad = ErrorCode::invalid_file;
constexpr auto unsupported = ErrorCode::unsupported;

/// A file in its own folder. By default it has one member "a".
struct File {
    TemporaryFolder folder;
    std::filesystem::path path = folder / "f.npz";

    void write(const std::string& npy_bytes, bool deflated = false) {
        write_bytes(path, archive({ArchiveMember("a.npy", npy_bytes, deflated)}));
    }
    NpyArray read() const { return read_npz_member(path, "a"); }
    /// Writes a file that must be refused.
    template <class... Parts>
    void refuse_npy(const std::string& npy_bytes, ErrorCode code, const Parts&... parts) {
        write(npy_bytes);
        refuse(code, parts...);
    }
    template <class... Parts>
    void refuse(ErrorCode code, const Parts&... parts) const {
        check_error(code, CALL(read()), "f.npz", parts...);
    }
};

const std::vector<double> some = {1, -2.5, 3e10, 4};

long peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

}  // namespace

TEST_CASE("a member's name ends at a zero byte, as it does for Python") {
    File file;
    const std::string content = npy(header("<f8", "(2, 2)"), raw(some));
    const std::string name("a.npy\0b", 7);
    write_bytes(file.path, archive({ArchiveMember(name, content)}));
    CHECK(file.read().values == some);
    CHECK(npz_members(file.path) == std::vector<std::string>{"a"});
    write_bytes(file.path, archive({ArchiveMember(name, content), ArchiveMember("a.npy", content)}));
    file.refuse(bad, "has member a.npy twice");
}

TEST_CASE("all four types, stored and deflated, are read") {
    File file;
    for (const bool deflated : {false, true}) {
        file.write(npy(header("<f8", "(2, 2)"), raw(some)), deflated);
        CHECK(file.read().values == some);
        CHECK(file.read().shape == std::vector<std::size_t>{2, 2});
        file.write(npy(header("<f4", "(3,)"), raw(std::vector<float>{1, -2.5f, 7})), deflated);
        CHECK(file.read().values == std::vector<double>{1, -2.5, 7});
        file.write(npy(header("<i4", "(3,)"), raw(std::vector<std::int32_t>{1, -2, 2000000000})), deflated);
        CHECK(file.read().values == std::vector<double>{1, -2, 2e9});
        file.write(npy(header("<i8", "()"), raw(std::vector<std::int64_t>{-(std::int64_t{1} << 53)})),
                   deflated);
        CHECK(file.read().values == std::vector<double>{-9007199254740992.0});
    }
    // The array exceeds every buffer and hardly compresses.
    std::vector<double> many(100000);
    std::mt19937 engine(1);
    for (double& v : many) v = std::uniform_real_distribution<double>(-1, 1)(engine);
    file.write(npy(header("<f8", "(100000,)"), raw(many)), true);
    CHECK(file.read().values == many);
    // One-dimensional arrays are equal in C and Fortran order.
    file.write(npy(header("<f8", "(4,)", true), raw(some)));
    CHECK(file.read().values == some);
}

TEST_CASE("headers of every version and layout are read") {
    File file;
    for (const int version : {1, 2, 3}) {
        file.write(npy(header("<f8", "(4,)"), raw(some), version));
        CHECK(file.read().values == some);
    }
    file.write(npy("{\"shape\":( 2,2 ) , 'fortran_order':False,'descr':\"<f8\"}", raw(some)));
    CHECK(file.read().shape == std::vector<std::size_t>{2, 2});
    // NumPy's local headers have a ZIP64 field, and archives may end with a comment.
    ArchiveMember member("a.npy", npy(header("<f8", "(4,)"), raw(some)));
    member.local_extra = std::string("\x01\x00\x10\x00", 4) + std::string(16, 'x');
    write_bytes(file.path, archive({member}, -1, "a comment"));
    CHECK(file.read().values == some);
}

TEST_CASE("other arrays are refused with what would be right") {
    File file;
    file.refuse_npy(npy(header("|O", "(4,)"), raw(some)), unsupported, "a.npy", "object");
    for (const char* type : {">f8", "<f2", "<u8", "|b1", "<c16", "<U4", ""})
        file.refuse_npy(npy(header(type, "(4,)"), raw(some)), unsupported, "<f8");
    file.refuse_npy(npy("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (4,), }", raw(some)),
                    unsupported, "records");
    file.refuse_npy(npy(header("<f8", "(2, 2)", true), raw(some)), unsupported, "Fortran");
    file.refuse_npy(npy(header("<f8", "(4,)"), raw(some), 4), unsupported, "version 4");
    file.refuse_npy(npy(header("<i8", "()"), raw(std::vector<std::int64_t>{(std::int64_t{1} << 53) + 1})),
                    bad, "2^53");
    file.refuse_npy(
        npy(header("<i8", "()"), raw(std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min()})),
        bad, "2^53");
}

TEST_CASE("malformed headers are refused") {
    File file;
    for (const std::string dictionary :
         {"", "{", "{}", "{'descr': '<f8'}", "{'descr': '<f8', 'fortran_order': Maybe, 'shape': (4,)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (4,)} x", "{'descr: '<f8'}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (-4,)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (4 4)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': 4}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (4,), 'more': (1,)}",
          "{'descr': '<f8' 'fortran_order': False, 'shape': (4,)}", "{'descr': '<f8, 'fortran_order': False"})
        file.refuse_npy(npy(dictionary, raw(some)), bad, "a.npy");
    std::string deep = "(";
    for (int i = 0; i < 33; ++i) deep += "1,";
    file.refuse_npy(npy(header("<f8", deep + ")"), raw(std::vector<double>{1})), bad, "malformed");
    file.refuse_npy("no array", bad);
    file.refuse_npy("not an array at all", bad, "not a NumPy array");
    file.refuse_npy("", bad);
    file.refuse_npy(npy(std::string(70000, ' '), "", 2), bad, "header of more than");
}

TEST_CASE("shapes that lie cost no memory") {
    File file;
    const long before = peak_megabytes();
    for (const char* shape : {"(5,)", "(3,)", "(0,)", "(1000000, 100)", "()"})
        file.refuse_npy(npy(header("<f8", shape), raw(some)), bad, "a.npy", "its shape needs");
    for (const char* shape : {"(1152921504606846976,)", "(99999999999999999999999,)",
                              "(4294967296, 4294967296)", "(0, 99999999999999999999999)"})
        file.refuse_npy(npy(header("<f8", shape), raw(some)), bad, "a.npy", "claims");
    check_error(
        bad,
        [&] {
            file.write(npy(header("<f8", "(4,)"), raw(some)));
            (void)read_npz_member(file.path, "a", 3);
        },
        "more than 3 values");
    // The directory and the header agree, but the data is missing.
    ArchiveMember member("a.npy", npy(header("<f8", "(50000000,)"), raw(some)), true);
    member.size = 400000064 + 11;
    write_bytes(file.path, archive({member}));
    file.refuse(bad, "cannot hold");
    CHECK(peak_megabytes() - before < 50);
}

TEST_CASE("archives that lie about their members are refused") {
    File file;
    const std::string good = npy(header("<f8", "(4,)"), raw(some));
    const auto with = [&](auto change, bool deflated) {
        ArchiveMember member("a.npy", good, deflated);
        change(member);
        write_bytes(file.path, archive({member}));
    };
    for (const bool deflated : {false, true}) {
        with([](ArchiveMember& m) { m.crc ^= 1; }, deflated);
        file.refuse(bad, "CRC-32");
        with([](ArchiveMember& m) { m.offset_error = 1; }, deflated);
        file.refuse(bad);
        with([](ArchiveMember& m) { m.offset_error = 1 << 30; }, deflated);
        file.refuse(bad, "outside");
        with([](ArchiveMember& m) { m.stored_size = 1 << 30; }, deflated);
        file.refuse(bad, "outside");
        with([](ArchiveMember& m) { m.flags = 1; }, deflated);
        file.refuse(unsupported, "encrypted");
        with([](ArchiveMember& m) { m.size = 0xffffffff; }, deflated);
        file.refuse(unsupported, "ZIP64");
    }
    with([](ArchiveMember& m) { m.method = 14; }, false);
    file.refuse(unsupported, "method 14");
    with([](ArchiveMember& m) { ++m.size; }, false);
    file.refuse(bad, "cannot hold");
    with([](ArchiveMember& m) { m.stored[3] = '\x7f'; }, true);
    file.refuse(bad);
    with([](ArchiveMember& m) { m.size -= 8; }, true);
    file.refuse(bad, "its shape needs");
    // The member inflates to less than its header and the directory say.
    with([](ArchiveMember& m) { m.size += 8; }, true);
    file.refuse(bad);

    write_bytes(file.path, archive({ArchiveMember("a.npy", good), ArchiveMember("a.npy", good)}));
    file.refuse(bad, "twice");
    write_bytes(file.path, archive({ArchiveMember("a.npy", good)}, 2));
    file.refuse(bad, "damaged directory");
    write_bytes(file.path, archive({ArchiveMember("b.npy", good), ArchiveMember("c.txt", good)}));
    file.refuse(bad, "no member a.npy", "b.npy", "c.txt");
    CHECK(npz_members(file.path) == std::vector<std::string>{"b"});
    write_bytes(file.path, archive({}));
    file.refuse(bad, "holds none");
}

TEST_CASE("every truncation and any flipped byte is an error or the truth") {
    File file;
    for (const bool deflated : {false, true}) {
        const std::string whole =
            archive({ArchiveMember("a.npy", npy(header("<f8", "(2, 2)"), raw(some)), deflated)});
        for (std::size_t n = 0; n < whole.size(); ++n) {
            write_bytes(file.path, whole.substr(0, n));
            file.refuse(bad);
        }
        int read = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            for (const int bit : {0, 3, 7}) {
                std::string bytes = whole;
                bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
                write_bytes(file.path, bytes);
                try {
                    CHECK(file.read().values == some);
                    ++read;
                } catch (const Error&) {
                }
            }
        }
        // Flipped bits in dates and versions are harmless; most others must be detected.
        CHECK(read < static_cast<int>(whole.size()));
    }
}

TEST_CASE("a file that is not there, or no archive") {
    const TemporaryFolder folder;
    check_error(ErrorCode::file_not_found, CALL(read_npz_member(folder / "none.npz", "a")), "none.npz");
    check_error(ErrorCode::file_not_found, CALL(read_npz_member(folder.path(), "a")), "cannot be opened");
    for (const std::string content :
         {"", "x", "a text that is longer than the record at the end of archives"}) {
        write_bytes(folder / "f.npz", content);
        check_error(bad, CALL(read_npz_member(folder / "f.npz", "a")), "f.npz", "ZIP");
    }
}

TEST_CASE("texts") {
    File file;
    file.write(npy(header("<U6", "()"), raw(std::vector<std::uint32_t>{'R', 'E', 'A', 'L', 0, 0})));
    CHECK(read_npz_text(file.path, "a") == "REAL");
    file.write(npy(header("|S4", "()"), "REAL"));
    CHECK(read_npz_text(file.path, "a") == "REAL");
    const auto refuse = [&](const std::string& bytes, ErrorCode code, const std::string& part) {
        file.write(bytes);
        check_error(code, CALL(read_npz_text(file.path, "a")), "a.npy", part);
    };
    refuse(npy(header("<f8", "()"), raw(std::vector<double>{1})), unsupported, "text");
    refuse(npy(header("<U1", "()"), raw(std::vector<std::uint32_t>{0x263a})), bad, "ASCII");
    refuse(npy(header("<U3", "()"), raw(std::vector<std::uint32_t>{'a', 0, 'b'})), bad, "zero");
    refuse(npy(header("<U1", "(2,)"), raw(std::vector<std::uint32_t>{'a', 'b'})), bad, "");
    refuse(npy(header("|S5000", "()"), std::string(5000, 'a')), bad, "1024");
    refuse(npy(header("<U1", "()"), "abc"), bad, "text");
}

TEST_CASE("what cannot be written is refused, and the file before stays") {
    const TemporaryFolder folder;
    const auto refuse = [&](const std::vector<NpzMember>& members, const std::string& part) {
        check_error(ErrorCode::invalid_argument, CALL(write_npz(folder / "a.npz", members)), part);
    };
    write_bytes(folder / "a.npz", "before");
    refuse({{"a", NpyArray{{2, 3}, {1, 2}}}}, "shape");
    refuse({{"a", NpyArray{{std::size_t{1} << 63, 2}, {}}}}, "shape");
    refuse({{"a", NpyArray{{}, {}}}}, "shape");
    refuse({{"a", ""}}, "ASCII");
    refuse({{"a", "gr\xc3\xbcn"}}, "ASCII");
    refuse({{"", "x"}}, "name");
    refuse({{"a", "x"}, {"a", "y"}}, "name");
    CHECK(file_bytes(folder / "a.npz") == "before");
    CHECK(folder.names().size() == 1);
    check_error(
        ErrorCode::write_failed,
        [&] {
            const std::vector<NpzMember> members = {{"a", "x"}};
            write_npz(folder / "none" / "a.npz", members);
        },
        "none");
}
