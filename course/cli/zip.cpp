#include "course/cli/zip.h"

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace course {

namespace {

std::uint32_t crc32(std::string_view text) {
    std::uint32_t crc = ~std::uint32_t{0};
    for (const char c : text) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

/// A number of so many bytes, the least significant one first.
struct Field {
    int bytes;
    std::size_t value;
};

std::string packed(std::initializer_list<Field> fields) {
    std::string text;
    for (const Field& field : fields)
        for (int k = 0; k < field.bytes; ++k)
            text += static_cast<char>((field.value >> (8 * k)) & 0xFF);
    return text;
}

/// What local and central header of a file have in common: version, flags,
/// method, time, date, checksum, both sizes, length of the name, of extras.
std::string common_header(const std::string& name, const std::string& text) {
    constexpr std::size_t first_of_1980 = (1 << 5) | 1;
    return packed({{2, 20},
                   {2, 0},
                   {2, 0},
                   {2, 0},
                   {2, first_of_1980},
                   {4, crc32(text)},
                   {4, text.size()},
                   {4, text.size()},
                   {2, name.size()},
                   {2, 0}});
}

}  // namespace

std::string zip_of(const std::map<std::string, std::string>& files) {
    constexpr std::size_t made_on_unix = (3 << 8) | 20;
    constexpr std::size_t plain_file = std::size_t{0100644} << 16;
    std::string archive, directory;
    for (const auto& [name, text] : files) {
        const std::string header = common_header(name, text);
        for (const std::string& part :
             {packed({{4, 0x02014b50}, {2, made_on_unix}}), header,
              packed({{2, 0}, {2, 0}, {2, 0}, {4, plain_file}}),
              packed({{4, archive.size()}}), name})
            directory += part;
        for (const std::string& part :
             {packed({{4, 0x04034b50}}), header, name, text})
            archive += part;
    }
    return archive + directory +
           packed({{4, 0x06054b50},
                   {2, 0},
                   {2, 0},
                   {2, files.size()},
                   {2, files.size()},
                   {4, directory.size()},
                   {4, archive.size()},
                   {2, 0}});
}

}  // namespace course
