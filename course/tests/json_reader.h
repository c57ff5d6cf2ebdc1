// Reads JSON that the course has written, for tests of the data of pages.
#pragma once

#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// One value; of the parts that it is not, they are empty.
struct JsonValue {
    std::string text;  ///< of a string; of another value as it is written
    std::vector<JsonValue> items;
    std::map<std::string, JsonValue> members;

    const JsonValue& operator[](const std::string& name) const {
        return members.at(name);
    }
    const JsonValue& operator[](std::size_t i) const { return items.at(i); }
    bool has(const std::string& name) const { return members.contains(name); }
    double number() const { return std::stod(text); }
    int integer() const { return std::stoi(text); }
    bool truth() const { return text == "true"; }
    std::vector<int> integers() const {
        std::vector<int> numbers;
        for (const JsonValue& item : items) numbers.push_back(item.integer());
        return numbers;
    }
};

/// Throws std::runtime_error where the text is no JSON.
class JsonReader {
public:
    static JsonValue read(std::string_view text) {
        JsonReader reader(text);
        JsonValue value = reader.value();
        if (!reader.rest_.empty()) throw std::runtime_error("text after JSON");
        return value;
    }

private:
    explicit JsonReader(std::string_view text) : rest_(text) {}

    JsonValue value() {
        if (take('[')) return array();
        if (take('{')) return object();
        if (take('"')) return {string(), {}, {}};
        const std::size_t end = rest_.find_first_of(",]}");
        const std::string word(rest_.substr(0, end));
        if (word.empty()) throw std::runtime_error("no value in JSON");
        rest_.remove_prefix(word.size());
        return {word, {}, {}};
    }

    JsonValue array() {
        JsonValue array;
        if (take(']')) return array;
        do array.items.push_back(value());
        while (take(','));
        expect(']');
        return array;
    }

    JsonValue object() {
        JsonValue object;
        if (take('}')) return object;
        do {
            expect('"');
            const std::string name = string();
            expect(':');
            object.members[name] = value();
        } while (take(','));
        expect('}');
        return object;
    }

    /// Up to the quote that ends it; escapes of one character only.
    std::string string() {
        std::string text;
        while (!take('"')) {
            take('\\');
            if (rest_.empty()) throw std::runtime_error("endless string");
            text += rest_[0];
            rest_.remove_prefix(1);
        }
        return text;
    }

    bool take(char c) {
        if (rest_.empty() || rest_[0] != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void expect(char c) {
        if (!take(c))
            throw std::runtime_error(std::string("expected in JSON: ") + c);
    }

    std::string_view rest_;
};

}  // namespace course
