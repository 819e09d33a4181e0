#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants one flaw at a time in a copy of a source file and checks that a test fails.

    scripts/mutate.py build/release build/tests [--only NAME ..] [--jobs N]

The folders are a shared release build of polydec and a build of the tests; neither is changed. Only
the mutated file is compiled (1 to 15 s) and preloaded. A copy of the library, linked without
-Bsymbolic-functions, then calls the mutated functions too. A mutant is `caught` if a test fails or
crashes, `survived` if all pass, `stale` if its source line changed. Exit code: 0 all were caught, 1 one
survived, 2 one is stale.

Flaws in templates and inline functions cannot be preloaded and are not listed.
"""
import argparse
import concurrent.futures
import json
import os
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# name: file, text that occurs once, replacement
MUTANTS = {
    # dec/
    "dual_derivative_sign": ("dec/forms/derivative.cpp", "k % 2 == 0 ? -1 : 1", "k % 2 == 0 ? 1 : -1"),
    "star_solve_multiplies": ("dec/forms/star.cpp", "return inverse().cwiseProduct(values);",
                              "return diagonal().cwiseProduct(values);"),
    "dual_volume_part": ("dec/metric/circumcentric_volumes.cpp", "is_top ? 1 : 1.0 / (n - k)",
                         "is_top ? 1 : 1.0 / (n - k + 1)"),
    "obtuse_duals_unsigned": ("dec/metric/circumcentric_volumes.cpp",
                              "face.dual += *number * share.dual;",
                              "face.dual += std::abs(*number) * share.dual;"),
    "gram_last_term_only": ("dec/forms/gram.cpp", "            values_[last_] += value;",
                            "            values_[last_] = value;"),
    "lifts_of_any_time": ("dec/merging/lift.cpp", "if (pieces > most_pieces)", "if (false)"),
    "wedge_share": ("dec/fields/wedge.cpp", "1.0 / (a.degree + b.degree + 1)",
                    "1.0 / (a.degree + b.degree + 2)"),
    "wedge_orientation": ("dec/fields/wedge.cpp",
                          "orientation(complex, k, f) * orientation(complex, l, g)",
                          "orientation(complex, k, f)"),
    "dual_wedge_no_alternation": ("dec/fields/dual_wedge.cpp",
                                  "(omitted % 2 == 0 ? value : -value)", "value"),
    "dual_wedge_orientation": ("dec/fields/dual_wedge.cpp",
                               "const Vector covector = chart.orientation * meet(",
                               "const Vector covector = meet("),
    "flat_sign": ("dec/fields/flat.cpp", "n % 2 == 0 ? 1 : -1", "n % 2 == 0 ? -1 : 1"),
    "flat_mean_weight": ("dec/fields/flat.cpp", "1.0 / (k + 1)), field", "1.0 / (k + 2)), field"),
    "flux_sharp_sign": ("dec/fields/sharp.cpp", "+= sign * form.values[f] * (facets.row(f)",
                        "+= form.values[f] * (facets.row(f)"),
    "de_rham_flag_sign": ("dec/fields/de_rham.cpp", "(i % 2 == 0 ? 1 : -1) * complex_.sign(i, s, omitted)",
                          "complex_.sign(i, s, omitted)"),
    "data_of_sorted_cells": ("dec/cell_data.cpp", "const Index row = input.input_row(t);",
                             "const Index row = t;"),
    "data_that_differ_joined": ("dec/cell_data.cpp", "> rounding * std::max(", "> 1e9 * std::max("),
    "forms_at_places_in_the_unit": ("dec/fields/de_rham.cpp", "const Vector point = unit * place;",
                                    "const Vector point = place;"),
    "points_in_the_unit": ("dec/discretization.cpp", "    if (unit() != 1)\n        given_", "    if (false)\n        given_"),
    "places_in_the_unit": ("dec/fields/cell_centers.cpp",
                           "    return discretization.unit() *\n           mean_over_cells(discretization, k, middles(",
                           "    return mean_over_cells(discretization, k, middles("),
    "streamlines_in_the_unit": ("dec/fields/streamlines.cpp", "    lines.points *= mesh.unit();\n", ""),
    "dual_volumes_in_the_unit": ("dec/input_units.cpp", "scaled(volumes.dual(k), n - k)",
                                 "scaled(volumes.dual(k), k)"),
    "vertices_of_splits_in_front": ("dec/input_vertices.cpp", ": v + unused;", ": v;"),
    "fixed_vertices_free": ("dec/forms/boundary_conditions.cpp",
                            "marks[0][v] || conditions.fixed_vertices[v]", "marks[0][v]"),
    "no_match_passes": ("dec/forms/boundary_conditions.cpp", "    if (!any)\n", "    if (false)\n"),
    "branches_of_dual_functions": ("dec/conditioned_complex.cpp", "if (counts[f] > 2)",
                                   "if (counts[f] > 9)"),
    "cure_guessed": ("dec/advice.cpp", "return are_positive(tried.surface, tried.lengths, options);",
                     "return true;"),
    "cure_not_told": ("dec/advice.cpp", "    if (count == 0 ||", "    if (true ||"),
    "tolerance_of_all": ("dec/merging/facet_kinds.cpp", "count(cofaces.begin(), cofaces.end(), 2) / 10",
                         "count(cofaces.begin(), cofaces.end(), 2)"),
    "groups_as_if_orthogonal": ("backends/spectra/found_pairs.cpp",
                                "                others_[i] += share;\n                others_[j] += share;\n", ""),
    "zeros_searched": ("backends/spectra/found_pairs.cpp", "    pairs.take(Y, pencil.enclose(Y));", ""),
    "sources_everywhere": ("dec/fields/chosen_vertices.cpp", "tag && of_cell == *tag", "tag && of_cell != 0"),
    "robin_one_for_all": ("dec/forms/boundary_conditions.cpp",
                          "result[f] = given.size() == 1 ? given[0] : given[f];",
                          "result[f] = given[0];"),
    "exchanged_keeps_facets": ("dec/forms/boundary_conditions.cpp",
                               "conditions.everywhere = other(conditions.everywhere);", ""),
    "essential_data_cut_off": ("solvers/hodge_laplace_equations.cpp",
                               "std::vector<bool> known = fixed[k];",
                               "std::vector<bool> known(fixed[k].size(), false);"),
    "slivers_left_out": ("dec/galerkin_mass.cpp",
                         "cells.geometry().flat().empty() ? cells : cone_flat_cells(cells)", "cells"),
    "dual_forms_over_duals": ("dec/fields/de_rham.cpp",
                              "if (!mesh.chosen_stars().is_over_duals(k)) {", "if (false) {"),
    "flats_over_duals": ("dec/fields/flat.cpp",
                         "!mesh.chosen_stars().is_over_duals(mesh.dimension() - 1))", "false)"),
    "boundary_star_by_duals": ("dec/boundary_star.cpp", "if (mesh.stars()[k + 1].is_diagonal())",
                               "if (true)"),
    "boundary_data_by_duals": ("dec/fields/de_rham.cpp",
                               "if (j > 0 && !mesh.stars()[n - j].is_diagonal())", "if (false)"),
    "input_cells_cut_off": ("meshes/mesh.cpp", "cells.of_simplices = followed(cells.of_simplices);",
                            "cells.of_simplices.resize(rows.size());"),
    "welded_by_equality": ("meshes/weld.cpp", "join_near(scaled_(open, Eigen::all), length, sets);", ";"),
    "polygons_in_any_unit": ("meshes/polygon_splitter.cpp", "    if (largest > 0)\n", "    if (false)\n"),
    "walls_forgotten": ("meshes/point_tree.cpp", "place - cell <= margin || place - cell >= 1 - margin", "false"),
    "cells_of_one_alone": ("meshes/point_tree.cpp", "if (cells[order[i]] == cells[order[i - 1]])", "if (false)"),
    "long_edges_welded": ("meshes/weld.cpp", "(scaled_.row(p) - scaled_.row(q)).norm() > lengths_[p]", "false"),
    "cells_turned_by_welding": ("meshes/weld.cpp", "if (is_turned(cell))", "if (false)"),
    "plates_welded": ("meshes/weld.cpp", "if (!one_place && !one_sign)", "if (false)"),
    "first_place_for_all": ("meshes/weld.cpp", "sources_(leader, axis) = *middle;",
                            "sources_(leader, axis) = members.front();"),
    "boxes_never_meet": ("meshes/point_tree.cpp", "        join_across(left, right, square, sets);", ""),
    "places_by_another_simplex": ("dec/fields/cell_centers.cpp", "points.row(corners(sum.anchor, i));",
                                  "points.row(corners(0, i));"),
    "cut_cells_not_laid_flat": ("dec/fields/cell_centers.cpp", "system.topRows(n_) = corners_.middleRows(row(sum.anchor), n_ + 1)",
                                "system.topRows(n_) = corners_.middleRows(0, n_ + 1)"),
    "seams_as_boundary": ("dec/fields/de_rham.cpp",
                          "result.push_back(counts[mesh.box() ? mesh.box()->onto(m)[f] : f] == 1);",
                          "result.push_back(placed(mesh).pieces().coface_counts(m)[f] == 1);"),
    "copies_counted_once": ("dec/glued_box.cpp", "result.row(onto[s]) += signs[s] * values.row(s);",
                            "result.row(onto[s]) = signs[s] * values.row(s);"),
    "pulled_back_without_sign": ("dec/glued_box.cpp", "result.row(s) = signs[s] * values.row(onto[s]);",
                                 "result.row(s) = values.row(onto[s]);"),
    "box_in_other_units": ("dec/glued_box.cpp", "glued.box.points / mesh.unit();", "glued.box.points;"),
    "groups_of_the_box_lost": ("dec/discretization.cpp",
                               "Mesh about{{}, {}, mesh.box.warnings, mesh.box.tags,",
                               "Mesh about{{}, {}, {}, {},"),
    "flips_with_places": ("dec/discretization.cpp", "    if (options.delaunay != Delaunay::off)\n        about.",
                          "    if (false)\n        about."),
    "slits_untold": ("dec/discretization.cpp", "warn_of_unjoined(unjoined_boundary(", "if (false) warn_of_unjoined(unjoined_boundary("),
    "facets_divided_alone": ("meshes/join_hanging.cpp", "n == 3 ? nodes.facets :", "n == 9 ? nodes.facets :"),
    "facets_with_holes_left": ("meshes/facet_overlay.cpp", "            add_fan(f, edges, result);\n", ""),
    "edges_never_cross": ("meshes/facet_overlay.cpp", "    cross(f, g, common);\n", ""),
    "remainders_lost": ("meshes/facet_overlay.cpp", "owners.push_back({f});", "owners.push_back({});"),
    "cones_over_any_corner": ("meshes/join_hanging.cpp", "is_fan = is_fan &&", "is_fan = true ||"),
    "parts_turned": ("meshes/join_hanging.cpp", "std::swap(corner[0], corner[1]);", ""),
    "edges_divided_backwards": ("meshes/divided_triangles.cpp", "    if (a > b)\n        std::reverse(",
                                "    if (a < b)\n        std::reverse("),
    "hybrid_by_sign": ("dec/choose_stars.cpp", "cell.value() < -rounding_[1][edge.col()]",
                       "cell.value() < 0"),
    "planes_unseen": ("dec/metric/plane.cpp",
                      "if (points.cols() <= n || points.rows() <= n)", "if (n > 0)"),
    "material_by_size": ("dec/material_stars.cpp", "return mesh.merged().parts(k, mesh.geometry().centers());",
                         "return mesh.merged().parts(k, mesh.geometry().centers()).cwiseAbs();"),
    "negative_boundary_duals_kept": ("dec/merging/merge.cpp", "!(duals[f] < 0) ||", "!(duals[f] < -1e9) ||"),
    "wound_twice_is_flat": ("dec/metric/overlaps.cpp", "2 * std::numbers::pi + 1e-6",
                            "8 * std::numbers::pi + 1e-6"),
    "kinds_by_rounding": ("dec/merging/facet_kinds.cpp", "is_zero(dual[f], terms[f])", "dual[f] == 0"),
    "numbers_lacked_in_silence": ("dec/diagnosis.cpp", "if (lacks_numbers(found))", "if (false)"),
    "lift_unmeasured": ("dec/merging/lift.cpp", "8.0 * static_cast<double>(cells.size())",
                        "0.0 * static_cast<double>(cells.size())"),
    "galerkin_unmeasured": ("dec/galerkin_mass.cpp", "check_memory(bytes_each * entries",
                            "check_memory(0 * entries"),
    "flips_by_numbers": ("dec/surfaces/intrinsic_delaunay.cpp", "-rounding ? sum / 2 : 0;",
                         "-rounding ? sum / 2 * (1 + edge % 7) : 0;"),
    "bends_unseen": ("dec/merging/straightness.cpp", "std::abs(angles_[s] - std::numbers::pi) <=",
                     "0 * angles_[s] <="),
    # shape/
    "mass_not_enlarged": ("shape/crouzeix_raviart.cpp", "-s * s / (1 - reach)", "0 * reach"),
    "doubt_of_means_left_out": ("shape/hybrid_form.cpp", "-s * s / ((1 - eps) * (1 - reach))", "0 * s"),
    "whole_gradient_left_over": ("shape/hybrid_form.cpp", "eps * (1 - reach)", "2 - reach"),
    "lumped_mass_of_ritz": ("shape/conforming.cpp", "degree == 1 ? mean_of_product(m, {i, k})",
                            "degree == 1 ? (i == k ? 1.0L / (m + 1) : 0)"),
    "twisted_signs_left_out": ("shape/gluing.cpp", "-pieces.sign(n, cell, omitted) *", "0 * n + 1 == 1 ? 1 :"),
    "trace_not_projected": ("shape/hybrid_form.cpp", "1.0L / (n + 1)));", "0));"),
    "conductivity_of_the_doubt": ("shape/hybrid_form.cpp", "rho * mass, rho * rho / kappa * doubt",
                                  "rho * mass, rho * rho * kappa * doubt"),
    "guess_taken_for_a_bound": ("shape/shape_spectrum.cpp", "i = *count; i < options_.count", "i = j; i < options_.count"),
    "too_large_simplices_counted": ("shape/trusted_count.cpp", "above * (1 + 1e-6) < lower.limit()", "above > 0"),
    "errors_of_lengths_forgotten": ("shape/measured_simplex.cpp", "shape.length_error + 8", "8"),
    "median_of_another_triangle": ("shape/bisection.cpp", "i == omitted ? -0.25L : 0.5L", "i == omitted ? -0.2L : 0.5L"),
    "conditions_of_parts_lost": ("shape/bisection.cpp", "length / 2, edges_[edge].parent);", "length / 2, -1);"),
    "orientation_of_parts": ("shape/bisection.cpp", "replaced == 1 ? -whole.orientation", "replaced == 3 ? -whole.orientation"),
    "paths_never_bend": ("shape/unfolded_triangles.cpp", "!is_simple || angles > most * (1 + rounding)", "false"),
    "pinched_as_disks": ("shape/unfolded_triangles.cpp", "!is_simple || angles >", "angles >"),
    "boundary_bends_as_inside": ("shape/unfolded_triangles.cpp", "2 * std::numbers::pi : std::numbers::pi",
                                 "2 * std::numbers::pi : 2 * std::numbers::pi"),
    "windows_pruned_too_soon": ("shape/windows.cpp", "[exit.pivot] + fan.end <", "[exit.pivot] + fan.begin <"),
    "third_corner_at_the_near_end": ("shape/windows.cpp", "shorter * leaving.distance(leaving.begin))",
                                     "shorter * leaving.distance(leaving.end))"),
    "the_other_part_is_useless": ("shape/windows.cpp", "nearest.cut < cut ? -1 : 1", "nearest.cut < cut ? 1 : -1"),
    "ties_drop_each_other": ("shape/windows.cpp", "shorter = 1 - 1e-15", "shorter = 1 + 1e-3"),
    "windows_turn_half_around": ("shape/windows.cpp", "exit.turns > static_cast", "2 * exit.turns > static_cast"),
    "windows_turn_for_ever": ("shape/windows.cpp", "exit.turns > static_cast", "false && exit.turns > static_cast"),
    "windows_in_one_direction": ("shape/windows.cpp", "sign > 0 ? known : known.reversed(exit.length)", "known"),
    "equal_windows_multiply": ("shape/windows.cpp", "        cut_off_known(known, edge);", "        {}"),
    "known_parts_everywhere": ("shape/windows.cpp", "!earlier.is_no_longer(fan, x, y)", "false"),
    "windows_without_end": ("shape/windows.cpp", "if (windows >= most)", "if (false)"),
    # solvers/
    "sources_pour_heat": ("solvers/surfaces/heat_distance.cpp", "if (!is_single(pins))", "if (false)"),
    "forces_of_another_power": ("solvers/flow/stokes.cpp", 'of.in_unit(force.values, n, "forces")',
                                'of.in_unit(force.values, n - 1, "forces")'),
    "darcy_flux_in_the_unit": ("solvers/darcy.cpp", "complex_.dimension() - 2", "0"),
    "gravity_of_another_power": ("solvers/flow/shallow_water.cpp", 'options.gravity), 2, "gravity")',
                                 'options.gravity), 1, "gravity")'),
    "friction_of_another_power": ("solvers/flow/flow_operators.cpp", 'unit, -2, "viscosity")',
                                  'unit, -1, "viscosity")'),
    "energy_of_waves_in_the_unit": ("solvers/leapfrog.cpp", "unit_, energy_power_,", "1, energy_power_,"),
    "outward_flow_in_the_unit": ("solvers/boundary_forms.cpp", "mesh.unit(), n - 1,", "mesh.unit(), 0,"),
    "tolerance_in_the_unit": ("solvers/evolution.cpp", 'mesh ? mesh->unit() : 1, degree, "sizes',
                              '1, degree, "sizes'),
    "growth_unseen": ("solvers/diffusion.cpp", "if (!(to <= from * (1 + rounding)))", "if (false)"),
    "steps_unscaled": ("solvers/diffusion.cpp", "A = scales_.asDiagonal() * A * scales_.asDiagonal();",
                       "scales_.setOnes();"),
    "modes_of_the_kept_star": ("solvers/spectrum.cpp",
                               "pairs.vectors = SparseMatrix(star.matrix()) * pairs.vectors;",
                               "pairs.vectors = space.relative.extend(k, SparseMatrix(stars[k].matrix()) "
                               "* space.relative.restrict(k, pairs.vectors));"),
    "robin_in_the_unit_of_the_mesh": ("dec/conditioned_complex.cpp", "coefficient *= mesh.unit();",
                                      "coefficient *= 1;"),
    "diffusion_in_the_unit_of_the_mesh": ("solvers/diffusion.cpp",
                                          "mesh.unit(), -2, \"coefficient", "mesh.unit(), 0, \"coefficient"),
    "time_of_an_evolution_without_unit": ("solvers/evolution.cpp",
                                          "self->unit * self->rate(self->unit * t, y)",
                                          "self->unit * self->rate(t, y)"),
    "waves_in_the_unit_of_the_mesh": ("solvers/leapfrog.cpp", "B_.put_back(unit_ * B, state.B);",
                                      "B_.put_back(std::move(B), state.B);"),
    "forms_with_sources_in_the_unit_of_the_mesh": ("solvers/hodge_laplace.cpp",
                                                   "unit_, 2, \"source\"", "unit_, 0, \"source\""),
    "robin_ignored_beside_fixed": ("solvers/hodge_laplace_equations.cpp",
                                   "add(b, b_terms, -1, robin, w);", ""),
    "leapfrog_dual_sign": ("solvers/leapfrog.cpp", "on.E % 2 == 0 ? 1.0 : -1.0", "on.E % 2 == 0 ? -1.0 : 1.0"),
    "leapfrog_loss_half": ("solvers/leapfrog.cpp", "(1 + time_step / 2 * loss.array())",
                           "(1 + time_step * loss.array())"),
    "leapfrog_limit": ("solvers/leapfrog.cpp", "return 2 / std::sqrt(largest.values[0]);",
                       "return 2.1 / std::sqrt(largest.values[0]);"),
    "hodge_star_star": ("solvers/hodge.cpp", "k_ * (n - k_) % 2 == 0 ? 1 : -1", "1"),
    "hodge_harmonic_not_projected": ("solvers/hodge.cpp", "forms.col(i) = w - coexact->of(w).form;",
                                     "forms.col(i) = w;"),
    "poisson_robin_dropped": ("solvers/poisson.cpp",
                              "            matrix += weights;\n", ""),
    "poisson_mixed_outflow_sign": ("solvers/poisson.cpp", "outflow = -(flux_load_ * normal_derivatives)",
                                   "outflow = flux_load_ * normal_derivatives"),
    "poisson_flux_load_dropped": ("solvers/poisson.cpp",
                                  "boundary_load_ * boundary_values + flux_load_ * normal_derivatives;",
                                  "boundary_load_ * boundary_values;"),
    "diffusion_explicit_sign": ("solvers/diffusion.cpp", "right_side -= explicit_part", "right_side += explicit_part"),
    "diffusion_shift_of_robin": ("solvers/diffusion.cpp", "b += of.upper * shift + of.robin * shift;",
                                 "b += of.upper * shift;"),
    "shallow_water_energy_head": ("solvers/flow/shallow_water.cpp", ".cwiseQuotient(parts.areas) / 4 +",
                                  ".cwiseQuotient(parts.areas) / 2 +"),
    "shallow_water_runge_kutta": ("solvers/flow/shallow_water.cpp", "(a.flux + 2 * b.flux + 2 * c.flux + d.flux) / 6",
                                  "(a.flux + 2 * b.flux + 2 * c.flux + d.flux) / 6.01"),
    "vorticity_in_the_unit": ("solvers/flow/flow_data.cpp", "PoissonSolver(mesh).solve(",
                              "PoissonSolver(mesh.complex(), mesh.stars()).solve("),
    "advection_sign": ("solvers/flow/advection.cpp", "p % 2 == 0 ? 1 : -1", "1"),
    "geodesic_gradient_half": ("solvers/surfaces/heat_distance.cpp",
                               "gradient.dot(hats[i]) / (2 * gradient.norm())",
                               "gradient.dot(hats[i]) / gradient.norm()"),
    "inertia_hidden": ("backends/spectra/inertia.cpp", "return *negative - matrices_.hidden;",
                       "return *negative - matrices_.hidden + 1;"),
    # meshes/
    "diagonal_by_first_corner": ("meshes/polygon_splitter.cpp",
                                 "        flip_to_delaunay();\n    keep_result", "    {}\n    keep_result"),
    "corners_not_canonical": ("meshes/polygon_splitter.cpp", "    rotate_to_first(corners);\n", ""),
    "ties_by_rounding": ("meshes/polygon_splitter.cpp",
                         "return 32 * std::numeric_limits<double>::epsilon()",
                         "return 0 * std::numeric_limits<double>::epsilon()"),
    "diagonals_twice": ("meshes/polygons.cpp", "if (end - begin == 1 && !is_side)", "if (!is_side)"),
    "diagonals_are_sides": ("meshes/polygons.cpp",
                            "std::binary_search(sides.begin(), sides.end(), edge)", "false"),
    "keeper_by_number": ("meshes/polygons.cpp", "constexpr double rounding = 1e-12;",
                         "constexpr double rounding = 10;"),
    "pulled_from_the_first_corner": ("meshes/split_cells.cpp",
                                     "*std::min_element(corners.begin(), corners.end())", "corners[0]"),
    "collapsed_corners_kept": ("meshes/split_cells.cpp", "!apexes_.empty() && i < corners.size()",
                               "false && i < corners.size()"),
    "tags_uncounted": ("meshes/polygons.cpp", "polygons.tags.size() + 1 != offsets.size()", "false"),
    "solids_not_turned": ("meshes/split_cells.cpp", "volume < 0 && s", "false && s"),
    "far_holes_overflow": ("meshes/tetgen/tetgen_input.cpp", ".cwiseMax(-far).cwiseMin(far)", ""),
    "outermost_emptied": ("meshes/tetgen/tetgen_input.cpp", "volumes[part] < volumes[innermost]",
                          "volumes[part] > volumes[innermost]"),
    "triangles_without_patches": ("meshes/tetgen/tetgen_files.cpp",
                                  "input.patches[static_cast<std::size_t>(f)] + 1", "f + 1"),
    "facets_uncovered": ("meshes/tetgen/tetgen_output.cpp",
                         "std::abs(found[f] - areas[f]) > patch_tolerance * areas[f]", "false"),
    "ends_off_the_surface": ("meshes/tetgen/tetgen_output.cpp", "result.ends_elsewhere = true;", "{}"),
    # io/
    "ply_header_ends_with_lf": ("io/meshes/ply_header.cpp", "!breaks_lines_with_cr() &&", "false &&"),
    "gmsh_4_0_numbers_first": ("io/meshes/read_gmsh.cpp", "numbers_first = !format_.is_4_0()", "numbers_first = true"),
    "gmsh_name_ends_line": ("io/meshes/gmsh_groups.cpp", "scanner.next_line(); // other", "// other"),
    "vtk_nodes_are_corners": ("io/meshes/vtk_cells.cpp", "corners_.resize(nodes / 2);", "{}"),
    "vtk_grid_order": ("io/meshes/vtk_grid.cpp", "stride *= points;", "stride += points;"),
    "vtk_binary_string": ("io/meshes/vtk_source.cpp", "(3U - (first >> 6U))", "(first >> 6U)"),
    "vtu_slit_joined": ("io/meshes/read_vtu.cpp", "order[joins ? begin : i]", "order[begin]"),
    "vtu_inflates_all": ("io/meshes/vtu_arrays.cpp", "if (array.numbers && promised !=",
                         "if (false && promised !="),
    "vtu_holds_any_promise": ("io/meshes/vtu_arrays.cpp", "if (promised > decoder.capacity())", "if (false)"),
    "vtu_inflates_before_it_checks": ("io/meshes/read_vtu.cpp", "        vtu_.check(piece);\n", ""),
    "off_plane": ("io/meshes/read_off.cpp", "axes = count_axes(scanner, vertices);", "axes = 3;"),
    "stl_rest_unsaid": ("io/meshes/read_stl.cpp", "if (file.text.size() > promised_bytes(file)) {", "if (false) {"),
    "fortran_exponent": ("io/scanner.cpp", "= 'e';", "= 'E', text += '0';"),
    "medit_nodes": ("io/meshes/read_medit.cpp", "if (node < section.corners)", "if (node >= section.nodes - section.corners)"),
    "cells_beside_unsaid": ("io/meshes/cell_lists.cpp", "if (count == 0)", "if (true)"),
    "foreign_unsaid": ("io/meshes/foreign_format.cpp", "if (own == mark.extension)", "if (true)"),
    "obj_counted_back": ("io/meshes/read_obj.cpp", "vertices() + number;", "vertices() + number - 1;"),
    "ply_vertex_bound": ("io/meshes/read_ply.cpp", "value < vertices_) || value != std::floor(value)",
                         "value <= vertices_) || value != std::floor(value)"),
    "ply_length_bound": ("io/meshes/read_ply.cpp", "length <= most)", "true)"),
    "fingerprint_of_star_names": ("io/checkpoint.cpp", "        add(mesh.stars()[k]);", "        add(double(k));"),
    "stl_axis": ("io/meshes/read_stl.cpp", "place + 4 * axis", "place + 4 * (2 - axis)"),
    "stl_corner_offset": ("io/meshes/read_stl.cpp", "normal_bytes * (1 + corner)", "normal_bytes * corner"),
    "matrix_market_place": ("io/matrices/read_matrix_market.cpp", "if (place < 1 || place > size)",
                            "if (place < 0 || place > size)"),
    "matrix_market_skew": ("io/matrices/read_matrix_market.cpp", "symmetry == MatrixSymmetry::skew ? -value : value",
                           "value"),
    "vtk_pixel": ("io/meshes/vtk_cells.cpp", "std::swap(corners_[i], corners_[i + 1]);", ""),
    "vtk_strip": ("io/meshes/vtk_cells.cpp", "i % 2 != 0, tag", "i % 2 == 0, tag"),
    "vtk_last_edge": ("io/meshes/vtk_cells.cpp", "i + 1 < corners.size()", "i + 2 < corners.size()"),
}


# The test programs that each folder's flaws are asked of, one after the other.
PROGRAMS = {folder: (f"{folder}/test_{folder}",) for folder in ("io", "meshes", "shape", "solvers")}
PROGRAMS["dec"] = ("dec/test_dec", "solvers/test_solvers")
PROGRAMS["backends"] = ("solvers/test_solvers",)
SECONDS = 600


def flags(build, path):
    """Compiler command of the file, or of its module's unity file, up to -o; working directory."""
    unity = f"/unity_{path.split('/', 1)[0]}_cxx.cxx"
    entries = json.loads((build / "compile_commands.json").read_text())
    entry = next((entry for wanted in ("/" + path, unity) for entry in entries
                  if entry["file"].endswith(wanted)), None)
    if entry is None:
        sys.exit(f"{path}: no command in {build}/compile_commands.json compiles it")
    words = shlex.split(entry["command"])
    return words[:words.index("-o")], entry["directory"]


def open_library(build, folder):
    """Links a copy of the library without -Bsymbolic-functions, so that preloaded functions replace
    its own."""
    name = next(build.glob("lib/libpolydec.so.*.*")).relative_to(build)
    commands = subprocess.run(["ninja", "-C", build, "-t", "commands", name], check=True,
                              capture_output=True, text=True).stdout.splitlines()
    link = commands[-1].replace("-Wl,-Bsymbolic-functions", "")
    subprocess.run(link.replace(f"-o {name}", f"-o {folder}/libpolydec.so.0"), shell=True, check=True,
                   cwd=build)


def compiled(build, work, name):
    """Path of the shared object with the flaw, or None and the reason."""
    path, old, new = MUTANTS[name]
    source = (ROOT / path).read_text()
    if source.count(old) != 1:
        return None, f"text occurs {source.count(old)} times in {path}, expected once"
    mutated, shared = work / f"{name}.cpp", work / f"{name}.so"
    mutated.write_text(f'#line 1 "{path}"\n' + source.replace(old, new))
    command, where = flags(build, path)
    run = subprocess.run([*command, "-w", "-shared", "-o", shared, mutated], cwd=where,
                         capture_output=True, text=True)
    return (shared, "") if run.returncode == 0 else (None, "does not compile: " + run.stderr[-400:])


def verdict(tests, work, name, shared):
    """Name of the first failing test; "" if all pass."""
    for program in PROGRAMS[MUTANTS[name][0].split("/")[0]]:
        run = subprocess.run([tests / program, "--gtest_brief=1", "--gtest_fail_fast"],
                             env=dict(os.environ, LD_PRELOAD=str(shared), LD_LIBRARY_PATH=str(work),
                                      POLYDEC_ENGINES="", RC_PARAMS="seed=1", OMP_NUM_THREADS="1"),
                             capture_output=True, text=True, errors="replace", timeout=SECONDS)
        failed = [line.split("]")[1].strip() for line in run.stdout.splitlines()
                  if "[  FAILED  ]" in line]
        if run.returncode != 0:
            return failed[0] if failed else f"ended with {run.returncode}"
    return ""


def ask(build, tests, work, name):
    """The verdict, one of caught, survived and stale, and its details."""
    begin = time.monotonic()
    shared, flaw = compiled(build, work, name)
    if shared is None:
        return "stale", flaw
    try:
        seen = verdict(tests, work, name, shared)
    except subprocess.TimeoutExpired:
        seen = f"took more than {SECONDS} s"
    shared.unlink()
    return "caught" if seen else "survived", f"{time.monotonic() - begin:.1f} s  {seen}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path, help="release build of polydec, its library shared")
    parser.add_argument("tests", type=Path, help="build of the tests")
    parser.add_argument("--only", nargs="+", choices=sorted(MUTANTS), default=list(MUTANTS),
                        metavar="NAME", help="these flaws alone")
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1))
    arguments = parser.parse_args()
    build, tests = arguments.build.resolve(), arguments.tests.resolve()
    ended = {"caught": 0, "survived": 0, "stale": 0}
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = Path(folder)
        open_library(build, work)
        asked = {pool.submit(ask, build, tests, work, name): name for name in arguments.only}
        for done in concurrent.futures.as_completed(asked):
            how, what = done.result()
            ended[how] += 1
            print(f"{how:8}  {asked[done]}  {what}", flush=True)
    print(", ".join(f"{count} {how}" for how, count in ended.items()))
    return 2 if ended["stale"] else 1 if ended["survived"] else 0


if __name__ == "__main__":
    sys.exit(main())
