// Ids for students: fit for file names, unique, and stable.
#include "grader/pipeline/safe_id.h"

#include <set>

#include "course/runner/catch2.h"

using namespace grader;

TEST_CASE("a name that is safe already is its own id") {
    for (const char* name :
         {"anna", "Anna.Rossi", "s123456", "a_b-c.d", "submission_42", "x"})
        CHECK(safe_id(name) == name);
}

TEST_CASE("what is not safe is replaced, and a hash keeps names apart") {
    CHECK(safe_id("Anna Rossi").substr(0, 11) == "Anna_Rossi-");
    CHECK(safe_id("../../etc/passwd").substr(0, 11) == "etc_passwd-");
    CHECK(safe_id("-rf").substr(0, 3) == "rf-");
    CHECK(safe_id("...").substr(0, 8) == "student-");
    CHECK(safe_id("").substr(0, 8) == "student-");
    CHECK(safe_id("\xff\n=").substr(0, 8) == "student-");
    CHECK(safe_id(std::string(300, 'n')).size() == 49);
    CHECK(safe_id("Anna Rossi") != safe_id("Anna_ Rossi"));
    CHECK(safe_id("e\xCC\x81") != safe_id("\xC3\xA9"));
}

TEST_CASE("names of devices are not ids") {
    for (const char* name : {"con", "CON", "nul.txt", "Lpt1", "aux.tar.gz"}) {
        CAPTURE(name);
        CHECK(safe_id(name) != name);
        // Everything up to the first dot decides.
        CHECK(safe_id(name).find('.') == std::string::npos);
        CHECK(safe_id(name).find('-') != std::string::npos);
    }
    CHECK(safe_id("console") == "console");
}

TEST_CASE("nobody gets another's id by choosing it as a name") {
    const std::string id = safe_id("Anna Rossi");
    CHECK(safe_id(id) != id);
    const auto ids = safe_ids({"Anna Rossi", id});
    CHECK(ids[0] == id);
    CHECK(ids[1] != id);
}

TEST_CASE("ids differ even where capitals do not count") {
    const std::vector<std::string> names = {"anna", "Anna", "ANNA", "bruno",
                                            "con",  "CON",  "a b",  "A B"};
    const auto ids = safe_ids(names);
    std::set<std::string> folded;
    for (std::string id : ids) {
        for (char& c : id) c = static_cast<char>(std::tolower(c));
        CHECK(folded.insert(id).second);
    }
    CHECK(ids[3] == "bruno");
}

TEST_CASE("an id does not depend on the order or on the others") {
    const auto a = safe_ids({"x y", "bruno", "carla"});
    const auto b = safe_ids({"carla", "zoe", "x y"});
    CHECK(a[0] == b[2]);
    CHECK(a[2] == b[0]);
    const auto c = safe_ids({"Anna", "anna"});
    const auto d = safe_ids({"anna", "Anna"});
    CHECK(c[0] == d[1]);
    CHECK(c[1] == d[0]);
}

TEST_CASE("equal hashes are told apart by a number") {
    // Found by search: the same 32-bit FNV-1a hash, and no harmless letter.
    const std::string a = "!@^^&", b = "!$%*!";
    REQUIRE(safe_id(a) == safe_id(b));
    const auto ids = safe_ids({a, b});
    CHECK(ids[0] == safe_id(a));
    CHECK(ids[1] == safe_id(a) + ".2");
}
