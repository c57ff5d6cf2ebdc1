// Recognises mistakes: a submission that fails exactly the cases, and in the
// way, that a stored wrong submission fails has probably its mistake.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/runner/results.h"
#include "grader/gradebook/gradebook.h"
#include "grader/pipeline/executor.h"
#include "grader/pipeline/grade_class.h"

namespace grader {

/// Equal for results with the same cases and the same verdict of each; empty
/// where nothing can be told by it, as no case passed, or all did, or none was
/// run.
std::string fingerprint(const course::ExerciseResult& result);

/// Judges the stored wrong submissions that some result of the run may turn out
/// to be like, where this suite has not judged them before, and writes down
/// with the run what it knows of them. What was judged is kept in the build's
/// folder, under the key of every result, for all classes. An exercise of which
/// not all could be judged gets none: the others would seem to be the only
/// ones. `say` is told what takes time, or cannot be kept.
void learn_mistakes(const ClassRun& run, int number, Gradebook& gradebook,
                    Executor& executor,
                    const std::function<void(const std::string&)>& say,
                    const std::function<bool()>& stop);

/// What is known of a result.
struct RecognisedMistake {
    std::string mistake;  ///< for instructors
    std::string hint;     ///< for students; may be empty
};

/// The mistake of the stored wrong submission with the result's fingerprint, or
/// of several which have the same hint; none where it fits others as well.
std::optional<RecognisedMistake> recognised(
    const std::vector<KnownMistake>& known, const std::string& exercise,
    const course::ExerciseResult& result);

}  // namespace grader
