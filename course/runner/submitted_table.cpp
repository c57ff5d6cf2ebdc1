#include "course/runner/submitted_table.h"

#include "course/runner/case_record.h"
#include "course/runner/client.h"
#include "course/runner/exercises.h"
#include "course/runner/table_csv.h"

namespace course {

namespace {

std::string the_file;

}  // namespace

void set_submitted_file(const std::string& path) {
    the_file = path;
}

std::vector<std::vector<std::optional<int>>> submitted_table() {
    const std::string text = read_file(the_file);
    try {
        return parse_table_csv(text);
    } catch (const CsvError& error) {
        Failure failure;
        failure.call = "the table that you handed in";
        failure.expected = "a csv file of half-edges";
        failure.got = error.what();
        case_record().add(Verdict::compile_error, std::move(failure));
        throw WorkerFailed{};
    }
}

}  // namespace course
