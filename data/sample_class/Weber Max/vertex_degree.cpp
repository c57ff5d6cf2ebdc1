#include "exercises/01_traversal/vertex_degree.h"

#include <cstdio>

int vertex_degree(const HalfEdgeTable& he, int i) {
    int start = i, grad = 0;
    do {
        printf("[vertex_degree] bin bei %d (vi=%d fi=%d next=%d opp=%d)\n", i,
               he[i].vi, he[i].fi, he[i].next, he[i].opp);
        grad++;
        i = he[i].opp;
        i = he[i].next;
    } while (i != start);
    printf("[vertex_degree] <b>Ergebnis</b> \033[31m%d\033[0m\n", grad);
    return grad;
}
