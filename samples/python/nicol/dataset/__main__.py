# SPDX-License-Identifier: MIT
import sys

from .program import main

sys.exit(main())
