#include "grader/bench/report.h"

#include <fmt/format.h>

#include <cstdio>

namespace grader::bench {

namespace {

/// About four digits.
std::string number(double value) {
    if (value >= 100) return fmt::format("{:.0f}", value);
    if (value >= 1) return fmt::format("{:.2f}", value);
    return fmt::format("{:.4f}", value);
}

void print(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

}  // namespace

void Report::begin_part(const std::string& name, const std::string& what) {
    part_ = name;
    print(fmt::format("\n{}: {}\n  {:46} {:>10} {:21} {}", name, what, "",
                      "median", "  quartiles", "rounds"));
    numbers_["parts"][part_]["what"] = what;
}

void Report::add(const Row& row) {
    const double median = quantile(row.samples, 0.5);
    const double lower = quantile(row.samples, 0.25);
    const double upper = quantile(row.samples, 0.75);
    nlohmann::ordered_json entry = {{"unit", row.unit},
                                    {"median", median},
                                    {"lower", lower},
                                    {"upper", upper},
                                    {"samples", row.samples}};
    std::string verdict;
    if (row.target) {
        const bool met = median <= *row.target;
        verdict = fmt::format("   target {}: {}", number(*row.target),
                              met ? "met" : "NOT met");
        entry["target"] = *row.target;
        entry["met"] = met;
    }
    print(fmt::format("  {:46} {:>6} {:3}  {:>6} .. {:<10} {}{}", row.name,
                      number(median), row.unit, number(lower), number(upper),
                      row.samples.size(), verdict));
    numbers_["parts"][part_]["rows"][row.name] = std::move(entry);
}

void Report::note(const std::string& text) {
    print("  " + text);
    numbers_["parts"][part_]["notes"].push_back(text);
}

void Report::fact(const std::string& name, const std::string& text) {
    print(fmt::format("{}: {}", name, text));
    numbers_["facts"][name] = text;
}

}  // namespace grader::bench
