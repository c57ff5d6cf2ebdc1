// What the subscript of the table throws.
#pragma once

#include <stdexcept>

/// Thrown by he[i] when the table has no row i.
struct OutOfTable : std::out_of_range {
    using std::out_of_range::out_of_range;
};

/// Thrown by he[i] when a call has used up its budget of reads: its walk does
/// not end, or it looks at more rows than the exercise allows.
struct TooManyReads : std::runtime_error {
    using std::runtime_error::runtime_error;
};
