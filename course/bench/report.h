// What was measured, as a table of times and ratios.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bench {

/// Seconds or bytes by what was done and by whom.
class Results {
public:
    /// A line of the table, if it is not there yet.
    void expect(const std::string& what);

    /// Keeps the smallest of several.
    void add(const std::string& what, const std::string& who, double value);

    /// A line for each `what`, in the order they were expected: the value of
    /// the first of `who`, scaled, and its ratio to each of the others.
    std::string table(const std::vector<std::string>& who, double scale,
                      const char* unit) const;

private:
    std::vector<std::string> order_;
    std::map<std::pair<std::string, std::string>, double> values_;
};

}  // namespace bench
