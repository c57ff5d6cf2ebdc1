#include "exercises/09_processing/report_defects.h"

DefectReport report_defects([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): sort out unsound faces first, then look at each edge.
    return {{-1}, {}, {}, {}, {}, {}, -1, -1};
}
