// The table that students hand in as CSV: any bytes are rows of five cells, or
// an error that is short and fit to be shown.
#include "course/runner/table_csv.h"

#include <algorithm>

#include "grader/fuzz/fuzz.h"

namespace {

using Rows = std::vector<std::vector<std::optional<int>>>;

std::string csv_of(const Rows& rows) {
    std::string text = "half_edge,vi,fi,next,opp\n";
    for (const auto& row : rows) {
        for (const std::optional<int>& cell : row)
            text += (cell ? std::to_string(*cell) : "") + ",";
        text.back() = '\n';
    }
    return text;
}

bool is_printable(char c) {
    return c == '\n' || (c >= ' ' && c <= '~');
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const Rows rows = course::parse_table_csv(fuzz::text_of(data, size));
        for (const auto& row : rows)
            fuzz::require(row.size() == 5, "a row has five cells");
        fuzz::require(course::parse_table_csv(csv_of(rows)) == rows,
                      "what is written is read again");
    } catch (const course::CsvError& error) {
        const std::string_view message = error.what();
        fuzz::require(message.size() < 10'000, "messages are short");
        fuzz::require(std::all_of(message.begin(), message.end(), is_printable),
                      "messages are printable");
    }
    return 0;
}
