#include "exercises/00_table/validate.h"

#include <algorithm>

#include "course/runner/suite.h"

using namespace course;

namespace {

using Findings = std::vector<Finding>;

Findings sorted(Findings findings) {
    std::sort(findings.begin(), findings.end());
    return findings;
}

/// These findings and no other, each once, in any order.
ListMatcher<Findings> AreFindings(Findings expected) {
    return {std::move(expected), sorted, "are, in any order, "};
}

}  // namespace

TEST_CASE("the slide table keeps all rules", "[points:1]") {
    hint("Which rule do you ask, and does the border keep it as well?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(::validate(slide.he), AreFindings({}));
}

TEST_CASE("an index of a half-edge that does not exist is found",
          "[points:1]") {
    hint("Which numbers are rows of the table? Did you ask before you read?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    {
        HalfEdgeTable he = slide.he;
        he[3].next = 16;
        INFO("the slide table with he[3].next = 16");
        CHECK_THAT(::validate(he),
                   AreFindings({{Fault::next_out_of_range, 3}}));
    }
    {
        HalfEdgeTable he = slide.he;
        he[3].opp = -1;
        INFO("the slide table with he[3].opp = -1");
        CHECK_THAT(::validate(he), AreFindings({{Fault::opp_out_of_range, 3},
                                                {Fault::opp_not_mutual, 4}}));
    }
}

TEST_CASE("one wrong cell may break several rules", "[points:1]") {
    hint("Which other half-edges rely on the cell that is wrong?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    {
        HalfEdgeTable he = slide.he;
        he[3].next = 1;
        INFO("the slide table with he[3].next = 1");
        CHECK_THAT(::validate(he), AreFindings({{Fault::next_not_at_tip, 3},
                                                {Fault::next_shared, 3},
                                                {Fault::next_shared, 5}}));
    }
    {
        HalfEdgeTable he = slide.he;
        he[12].opp = 7;
        INFO("the slide table with he[12].opp = 7");
        CHECK_THAT(::validate(he), AreFindings({{Fault::opp_not_mutual, 6},
                                                {Fault::opp_not_mutual, 12},
                                                {Fault::opp_same_start, 12},
                                                {Fault::next_not_at_tip, 12}}));
    }
}

TEST_CASE("the tables of generated meshes keep all rules", "[points:1]") {
    hint("Do you find a fault in a table that has none? Read that rule again.");
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        REQUIRE_THAT(::validate(mesh.he), AreFindings({}));
    });
}
