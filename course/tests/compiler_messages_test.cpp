// What becomes of the compiler's output: the student's own lines, the usual
// mistakes explained, what explains a failure first. The texts are those of
// g++ 12 and clang 14.
#include "course/report/compiler_messages.h"

#include "course/runner/catch2.h"

using namespace course;

namespace {

struct Example {
    const char* output;
    const char* advice;  // a part of it
};

std::string line(const std::string& kind, const std::string& text) {
    return "face_sides.cpp:8:19: " + kind + ": " + text + "\n";
}

std::string advice_on(const std::string& kind, const std::string& text) {
    const auto messages = compiler_messages(line(kind, text));
    REQUIRE(messages.size() == 1);
    CHECK(messages[0].is_error == (kind == "error"));
    return messages[0].advice;
}

void check_advice(const char* kind, const std::vector<Example>& examples) {
    for (const Example& example : examples) {
        const std::string advice = advice_on(kind, example.output);
        INFO(example.output << "\n" << advice);
        CHECK(advice.find(example.advice) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("the usual errors are explained in terms of the table") {
    check_advice(
        "error",
        {{"‘const struct HalfEdge’ has no member named ‘v’; did you mean ‘vi’?",
          "field vi"},
         {"no member named 'v' in 'HalfEdge'", "field vi"},
         {"‘const struct HalfEdge’ has no member named ‘face’", "field fi"},
         {"‘const struct HalfEdge’ has no member named ‘nxt’", "four fields"},
         {"no member named 'nxt' in 'HalfEdge'", "four fields"},
         {"‘srot’ is not a member of ‘std’", "#include"},
         {"no member named 'srot' in namespace 'std'", "#include"},
         {"cannot convert ‘const HalfEdge’ to ‘int’ in initialization",
          "whole row"},
         {"no viable conversion from 'const HalfEdge' to 'int'", "whole row"},
         {"assignment of member ‘HalfEdge::next’ in read-only object",
          "not changed"},
         {"cannot assign to return value because function 'operator[]' returns "
          "a const value",
          "not changed"},
         {"ambiguating new declaration of ‘double face_sides(int)’",
          "header of the exercise"},
         {"functions that differ only in their return type cannot be "
          "overloaded",
          "header of the exercise"},
         {"expected ‘;’ before ‘retrun’", "semicolon"},
         {"expected ';' after expression", "semicolon"},
         {"‘foo’ was not declared in this scope", "spelled"},
         {"use of undeclared identifier 'foo'", "spelled"},
         {"redeclaration of ‘int n’", "Leave out the type"}});
}

TEST_CASE("warnings that explain a failure are explained") {
    check_advice(
        "warning",
        {{"declaration of ‘int i’ shadows a parameter [-Wshadow]",
          "second variable"},
         {"declaration shadows a local variable [-Wshadow]", "second variable"},
         {"no return statement in function returning non-void [-Wreturn-type]",
          "no return"},
         {"non-void function does not return a value [-Wreturn-type]",
          "no return"},
         {"suggest parentheses around assignment used as truth value",
          "== compares"},
         {"using the result of an assignment as a condition without "
          "parentheses",
          "== compares"},
         {"this ‘while’ clause does not guard... [-Wmisleading-indentation]",
          "semicolon"},
         {"while loop has empty body [-Wempty-body]", "semicolon"},
         {"statement has no effect [-Wunused-value]", "thrown away"},
         {"expression result unused [-Wunused-value]", "thrown away"},
         {"‘n’ is used uninitialized [-Wuninitialized]", "before it was given"},
         {"variable 'n' is uninitialized when used here",
          "before it was given"},
         {"comparison of integer expressions of different signedness",
          "he.size()"}});
}

TEST_CASE("errors come first, then what explains, then the rest") {
    const auto messages = compiler_messages(
        "a.cpp:1:1: warning: comparison of integer expressions of different "
        "signedness: ‘int’ and ‘long’\n"
        "a.cpp:2:1: warning: declaration of ‘int i’ shadows a parameter\n"
        "a.cpp:3:1: error: ‘foo’ was not declared in this scope\n");
    REQUIRE(messages.size() == 3);
    CHECK(messages[0].place == "a.cpp:3:1");
    CHECK(messages[1].place == "a.cpp:2:1");
    CHECK(messages[1].explains_failures);
    CHECK(messages[2].place == "a.cpp:1:1");
    CHECK_FALSE(messages[2].explains_failures);
}

TEST_CASE("a message keeps its lines of source and where the other name is") {
    const std::string text = explain_compiler(
        "a.cpp: In function ‘int f(int)’:\n"
        "a.cpp:9:13: warning: declaration of ‘int i’ shadows a parameter\n"
        "    9 |         int i = j;\n"
        "      |             ^\n"
        "a.cpp:3:45: note: shadowed declaration is here\n"
        "    3 | int f(int i) {\n"
        "      |       ~~~~^\n"
        "a.cpp:9:13: warning: unused variable ‘i’ [-Wunused-variable]\n");
    INFO(text);
    CHECK(text.find("    9 |         int i = j;\n      |             ^\n") !=
          std::string::npos);
    CHECK(text.find("(line 3: shadowed declaration is here)") !=
          std::string::npos);
    CHECK(text.find("In function") == std::string::npos);
    CHECK(text.find("3 | int f") == std::string::npos);
    // The echo at the same place is left out.
    CHECK(text.find("unused variable") == std::string::npos);
}

TEST_CASE("an error inside a header stands at the line that led there") {
    const auto gcc = compiler_messages(
        "/usr/include/c++/12/bits/stl_algo.h: In instantiation of ‘void f()’:\n"
        "/usr/include/c++/12/bits/stl_algo.h:1937:25:   required from ‘x’\n"
        "a.cpp:7:14:   required from here\n"
        "/usr/include/c++/12/bits/predefined_ops.h:45:23: error: no match for "
        "‘operator<’\n"
        "   45 |       { return *__it1 < *__it2; }\n");
    REQUIRE(gcc.size() == 1);
    CHECK(gcc[0].place == "a.cpp:7:14");
    CHECK(gcc[0].source.empty());
    const auto clang = compiler_messages(
        "/usr/include/c++/12/bits/predefined_ops.h:45:23: error: invalid "
        "operands to binary expression ('A' and 'A')\n"
        "      { return *__it1 < *__it2; }\n"
        "a.cpp:7:10: note: in instantiation of function template "
        "specialization 'std::sort<A *>' requested here\n"
        "    std::sort(v.begin(), v.end());\n"
        "1 error generated.\n");
    REQUIRE(clang.size() == 1);
    CHECK(clang[0].place == "a.cpp:7:10");
}

TEST_CASE("three messages are shown, and the number of the others") {
    std::string output;
    for (int k = 1; k <= 5; ++k)
        output += "a.cpp:" + std::to_string(k) + ":1: error: no\n";
    const std::string text = explain_compiler(output);
    CHECK(text.find("a.cpp:3:1: error: no\n") != std::string::npos);
    CHECK(text.find("a.cpp:4:1") == std::string::npos);
    CHECK(text.find("(2 more messages") != std::string::npos);
}

TEST_CASE("lines of any length are read, and shown as far as anybody reads") {
    const std::string most(65'536, 'a');
    CHECK(explain_compiler("a.cpp:1:1: error: " + most).size() < 3000);
    CHECK(explain_compiler("a.cpp:1:1: warning: cannot convert '" + most +
                           "HalfEdge'\n" + most + "\n" + most)
              .size() < 9000);
    CHECK(explain_compiler(most) == most);
}

TEST_CASE("that the compiler was stopped stands before what it said") {
    const std::string why = "the compiler was stopped after 20 s\n";
    CHECK(explain_compiler(why + "a.cpp:1:1: warning: unused variable 'v'\n")
              .rfind(why + "\na.cpp:1:1: warning: unused", 0) == 0);
    CHECK(explain_compiler(why) == why);
}

TEST_CASE("what is no message of a compiler is left as it is") {
    const std::string text = "the file does not define int f(int)\n";
    CHECK(explain_compiler(text) == text);
    CHECK(explain_compiler("").empty());
}
