// A sweep as a workflow for Snakemake, so that any of its executors (cores, a cluster, a cloud) can
// run it.
#pragma once

#include <filesystem>

#include "datasets/plans/SweepPlan.h"

namespace umbra {

// Writes "Snakefile" into `folder`: a rule for each batch of `batch` cells, one call of `program`
// each, and one that makes the table of the parts. Throws BadOutput.
void writeSweepWorkflow(const SweepPlan& plan, const std::filesystem::path& planFile,
                        const std::filesystem::path& program, std::size_t batch,
                        const std::filesystem::path& folder);

}  // namespace umbra
