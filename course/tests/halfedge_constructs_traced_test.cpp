// Everyday constructs in the traced build, while it records.
#undef COURSE_TABLE
#define COURSE_TABLE 2
#include "course/tests/halfedge_constructs.h"

TEST_CASE("every construct gives its outcome in the traced build") {
    for (const Construct& construct : constructs) {
        INFO(construct.name);
        CHECK(outcome(construct) == construct.outcome);
    }
}

TEST_CASE("every change that a construct makes is recorded") {
    for (const Construct& construct : constructs) {
        INFO(construct.name);
        HalfEdgeTable he = slide_table();
        he.start_trace();
        const int result = construct.run(he, 4);
        std::vector<HalfEdge> replayed = slide_table().rows();
        replayed.resize(he.rows().size());
        for (const TraceEvent& event : he.stop_trace()) {
            if (event.table != 0) continue;
            for (const Change& change : event.changes) {
                HalfEdge& row = replayed[static_cast<std::size_t>(change.i)];
                int* const cells[] = {&row.vi, &row.fi, &row.next, &row.opp};
                CHECK(*cells[change.field] == change.before);
                *cells[change.field] = change.after;
            }
        }
        const HalfEdgeTable after(replayed);
        CHECK(fmt::format("{}{}", result, changes(slide_table(), after)) ==
              construct.outcome);
    }
}
