// Precompiled for submissions that use more of the standard library than
// prelude.h has.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "course/halfedge/table_errors.h"
#include "course/runner/prelude.h"
