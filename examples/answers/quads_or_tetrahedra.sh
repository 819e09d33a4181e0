# SPDX-License-Identifier: MIT
polydec info plate.msh
