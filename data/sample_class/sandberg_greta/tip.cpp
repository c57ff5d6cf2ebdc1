#include "exercises/00_table/tip.h"

#include <cstdio>

int tip(const HalfEdgeTable& he, int i) {
    // print the whole thing, 64 bytes * 16 million
    for (long k = 0; k < 1L << 24; k++)
        puts("half-edge half-edge half-edge half-edge half-edge half-edge abc");
    return he[he[i].next].vi;
}
