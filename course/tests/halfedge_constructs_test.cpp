// Everyday constructs in the checked build.
#undef COURSE_TABLE
#define COURSE_TABLE 1
#include "course/tests/halfedge_constructs.h"

TEST_CASE("every construct gives its outcome in the checked build") {
    for (const Construct& construct : constructs) {
        INFO(construct.name);
        CHECK(outcome(construct) == construct.outcome);
    }
}

TEST_CASE("every construct gives its outcome under the default budget") {
    for (const Construct& construct : constructs) {
        INFO(construct.name);
        HalfEdgeTable he = slide_table();
        he.begin_call(he.default_budget(), 4);
        construct.run(he, 4);
        CHECK(he.reads() <= 64);
    }
}
