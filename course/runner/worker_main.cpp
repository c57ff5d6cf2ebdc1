// course_worker SUBMISSION: the launcher without a sandbox, for lab. Control
// channel on descriptor 3.
#include <cstdio>

#include "course/runner/launcher.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: course_worker SUBMISSION.so (started by lab)\n",
                   stderr);
        return 2;
    }
    return course::run_launcher({argv[1]});
}
