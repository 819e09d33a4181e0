# SPDX-License-Identifier: MIT
"""Flaws of distributed/, which a single rank sees; see mutate.py."""

MUTANTS = {
    "spectra_of_books": ("distributed/spectrum.cpp", "if (side == Side::dual && degree == 0)", "if (side == Side::dual && degree < 0)",
                         "DistributedSpectrum.of_dual_functions_is_refused_where_three_cells_meet"),
    "ties_turned_as_one_likes": ("distributed/orientation.cpp", "balance == 0 ? given", "balance == 0 ? 1",
                                 "LocalComplexes.are_oriented_like_the_whole_however_cells_are_given"),
    "cofaces_of_pieces_unsigned": ("distributed/cell_numbers.cpp", "merged.carriers[k + 1][t].sign * local", "local",
                                   "DistributedOperators.are_those_of_one_process_in_every_degree_on_both_sides"),
    "flow_out_of_essential_facets": ("distributed/poisson.cpp", "outflow = signs.cwiseProduct(facets.natural)",
                                     "outflow = signs.cwiseProduct(facets.essential)",
                                     "DistributedPoisson.has_the_solution_of_one_process_with_all_conditions_on_both_sides"),
    "squares_of_data_out_of_range": ("distributed/shared_solver.cpp", "const int unit = std::ilogb(size);", "const int unit = 0;",
                                     "DistributedPoisson.solutions_are_as_large_as_the_data"),
}
