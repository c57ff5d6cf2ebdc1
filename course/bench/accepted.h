// Which meshes a library takes at all.
#pragma once

namespace bench {

/// Prints how many of `meshes` random ones each library takes: with bow-ties,
/// and with flaws of all kinds that were then cleaned. (Not with the geometry:
/// all vertices are at one place.)
void count_accepted(int meshes);

}  // namespace bench
