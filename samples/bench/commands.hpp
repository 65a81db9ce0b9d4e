// SPDX-License-Identifier: MIT
// The sub-commands of nicol-bench, one source each. All throw std::runtime_error with Nicol's message where a
// call fails.
#pragma once

#include "options.hpp"
#include "report.hpp"

/// Measures gradients by the environment beside pictures.
Report bench_adjoint(const Options& options);

/// Measures visibility at the vertices.
Report bench_bake(const Options& options);

/// Measures the light that surfaces reflect to each other, and what images err without it.
Report bench_bounces(const Options& given);
Report bench_glass(const Options& given);

/// Measures how frames keep a time_budget_ms.
Report bench_budget(const Options& given);

/// Counts the OpenGL calls of a frame inside a host's context.
Report bench_calls(const Options& options);

/// Measures errors of a mesh of few triangles, at vertices and at pixels.
Report bench_coarse(const Options& given);

/// Measures the steps from a picture to its files.
Report bench_dataset(const Options& options);

/// Measures what a change of objects, materials or light costs the frame after it.
Report bench_edit(const Options& options);
Report bench_motion(const Options& options);
Report bench_views(const Options& options);

/// Measures many frames of a host that moves an object, changes its window's size and has a job run.
Report bench_engine(const Options& options);

/// Measures the distance from the reference method, by order.
Report bench_error(const Options& options);

/// Measures errors of brushed and nearly smooth surfaces, narrow openings and close lights.
Report bench_extremes(const Options& given);

/// Measures the cost of a frame beside drawing the triangles.
Report bench_frame(const Options& options);

/// Measures transforms, rotation and projection: `seconds` for each line.
Report bench_harmonics(double seconds);

/// Measures errors of local lights, and what they add to a frame.
Report bench_lights(const Options& given);

/// Repeats Figure 21 for many materials: errors that each form of the high orders leaves.
Report bench_materials(const Options& given);

/// Measures run time against error. Writes the plot too if requested.
Report bench_pareto(const Options& options);

/// Measures what polarization costs beside s0 alone, by order.
Report bench_price(const Options& options);

/// Measures cost against the number of vertices and against the order.
Report bench_scale(const Options& options);

/// Measures errors far from the origin, on large floors and of close depths.
Report bench_places(const Options& given);

/// Measures what is saved by leaving out what a scene does not need.
Report bench_skip(const Options& options);

/// Measures the time from nothing to the first image.
Report bench_start(const Options& options);

/// Measures errors of a plastic that varies by textures.
Report bench_textures(const Options& given);

/// Compares requested, predicted and measured errors.
Report bench_tolerance(const Options& options);

/// Measures how long each function takes while a job runs.
Report bench_waits(const Options& options);
