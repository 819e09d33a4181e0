# SPDX-License-Identifier: MIT
polydec info box.off
polydec info box.off --weld
