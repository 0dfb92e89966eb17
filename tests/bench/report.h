#pragma once
#include <filesystem>
#include <vector>

#include "base/machine.h"
#include "bench/bench.h"
#include "bench/measure.h"

namespace ps::bench {

/// Turns milliseconds of one call into the bench's unit.
Row make_row(const Bench& bench, const Job& job, const Timing& timing);

/// `time` says what is measured.
void print_header(const Machine& machine, const MeasureOptions& options, const std::string& time);
void print_row(const Row& row);
/// Smallest ratio and geometric mean for each yardstick; how steep the curves are.
void print_summary(const std::vector<Row>& rows);
/// An array with one object for each row. Throws InputError if the file cannot be written.
void write_json(const std::filesystem::path& path, const std::vector<Row>& rows, const Machine& machine);

}  // namespace ps::bench
