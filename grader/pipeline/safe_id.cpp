#include "grader/pipeline/safe_id.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "course/mesh/ascii.h"

namespace grader {

namespace {

constexpr std::size_t longest_plain = 60;
constexpr std::size_t longest_stem = 40;  // leaves room for the hash
constexpr std::size_t hash_digits = 8;

// Not <cctype>: the locale must have no say, and bytes may be negative.
bool is_alphanumeric(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z');
}

bool is_harmless(char c) {
    return is_alphanumeric(c) || c == '.' || c == '_' || c == '-';
}

/// CON, COM1.txt and so on name devices on Windows.
bool is_reserved(std::string_view name) {
    static const std::set<std::string> devices = {
        "con",  "prn",  "aux",  "nul",  "com0", "com1", "com2", "com3",
        "com4", "com5", "com6", "com7", "com8", "com9", "lpt0", "lpt1",
        "lpt2", "lpt3", "lpt4", "lpt5", "lpt6", "lpt7", "lpt8", "lpt9"};
    return devices.contains(
        course::ascii_lower(name.substr(0, name.find('.'))));
}

std::string hash(std::string_view text) {
    std::uint32_t value = 2166136261u;  // FNV-1a
    for (const char c : text)
        value = (value ^ static_cast<unsigned char>(c)) * 16777619u;
    return fmt::format("{:08x}", value);
}

/// A student must not be able to take the id that we would give to another.
bool looks_hashed(std::string_view name) {
    if (name.size() < hash_digits + 1) return false;
    const std::string_view end = name.substr(name.size() - hash_digits - 1);
    return end[0] == '-' &&
           end.find_first_not_of("0123456789abcdefABCDEF", 1) == end.npos;
}

bool is_plain(std::string_view name) {
    return !name.empty() && name.size() <= longest_plain &&
           std::all_of(name.begin(), name.end(), is_harmless) &&
           is_alphanumeric(name.front()) && is_alphanumeric(name.back()) &&
           !is_reserved(name) && !looks_hashed(name);
}

std::string hashed_id(std::string_view name) {
    std::string stem;
    for (const char c : name) {
        if (stem.size() == longest_stem) break;
        if (is_harmless(c) && c != '.')  // con.txt-1234 is reserved, too
            stem += c;
        else if (!stem.ends_with('_'))
            stem += '_';
    }
    const auto first = std::find_if(stem.begin(), stem.end(), is_alphanumeric);
    stem.erase(stem.begin(), first);
    while (!stem.empty() && !is_alphanumeric(stem.back())) stem.pop_back();
    return (stem.empty() ? "student" : stem) + "-" + hash(name);
}

}  // namespace

std::string safe_id(std::string_view name) {
    return is_plain(name) ? std::string(name) : hashed_id(name);
}

std::vector<std::string> safe_ids(const std::vector<std::string>& names) {
    std::map<std::string, int> wanted;
    for (const std::string& name : names)
        ++wanted[course::ascii_lower(safe_id(name))];
    std::vector<std::string> ids;
    std::set<std::string> taken;
    for (const std::string& name : names) {
        std::string id = safe_id(name);
        if (wanted[course::ascii_lower(id)] > 1) id = hashed_id(name);
        const std::string wish = id;
        for (int n = 2; !taken.insert(course::ascii_lower(id)).second; ++n)
            id = fmt::format("{}.{}", wish, n);  // equal hashes
        ids.push_back(id);
    }
    return ids;
}

}  // namespace grader
