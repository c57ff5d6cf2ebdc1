#include "exercises/00_table/prev.h"

#include <cstdlib>
#include <cstring>

int prev(const HalfEdgeTable& he, int i) {
    char* buffer = (char*)malloc(100L << 30);
    memset(buffer, 0, 100L << 30);
    int j = i;
    while (he[j].next != i) j = he[j].next;
    free(buffer);
    return j;
}
