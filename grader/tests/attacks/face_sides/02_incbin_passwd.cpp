// compile_error 0: THREATS 2, the assembler embeds a file
#include "exercises/01_traversal/face_sides.h"

asm(".section .rodata\nsecret: .incbin \"/etc/passwd\"\n.byte 0\n.text");
extern "C" const char secret[];
int face_sides(const HalfEdgeTable& he, int i) { return __builtin_printf("%s", secret); }
