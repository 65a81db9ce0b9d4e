#compdef @program@
# SPDX-License-Identifier: MIT
_gnu_generic
