// Who handed in and when, as an export says it beside its folders.
#pragma once

#include "grader/pipeline/export_survey.h"

namespace grader {

/// Adds members and times of submission to the layout of `survey`, and notes
/// what could not be read. Precondition: no other thread runs.
///
/// Gradescope: of somebody who has handed in twice, alone or in a team, the
/// newest submission counts; one of which nobody is left is not graded, and a
/// note says so. GitHub: when HEAD was last moved by a commit.
void add_people(const ExportSurvey& survey, ExportLayout& layout);

}  // namespace grader
