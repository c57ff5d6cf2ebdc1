// The table of a measurement, and its numbers as JSON.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "grader/bench/measure.h"

namespace grader::bench {

struct Row {
    std::string name;
    Samples samples;
    std::string unit = {};              ///< empty for a ratio
    std::optional<double> target = {};  ///< the median is to be at most this
};

/// Prints each row as soon as it is known.
class Report {
public:
    /// A heading; the rows that follow belong to it.
    void begin_part(const std::string& name, const std::string& what);

    /// Precondition: the row has a sample.
    void add(const Row& row);

    /// What the table cannot say; goes to the JSON, too.
    void note(const std::string& text);

    /// A fact about the machine or the run.
    void fact(const std::string& name, const std::string& text);

    std::string json() const { return numbers_.dump(2) + "\n"; }

private:
    nlohmann::ordered_json numbers_;
    std::string part_;
};

}  // namespace grader::bench
