// The codec: bytes that decode are the bytes that the value encodes to, no
// more and no fewer; all others end in CodecError.
#include "course/runner/codec.h"

#include "grader/fuzz/fuzz.h"
#include "grader/fuzz/types.h"

namespace {

template <class T>
bool decodes(std::string_view bytes) {
    try {
        const T value = course::decode<T>(bytes);
        fuzz::require(course::encode(value) == bytes,
                      "what decodes encodes to the same bytes");
        return true;
    } catch (const course::CodecError&) {
        return false;
    }
}

template <class T>
void check(std::string_view bytes) {
    if (!decodes<T>(bytes)) return;
    fuzz::require(!decodes<T>(bytes.substr(0, bytes.size() - 1)),
                  "no byte may be missing");
    fuzz::require(!decodes<T>(std::string(bytes) + '\0'),
                  "no byte may be left over");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    fuzz::with_type(std::type_identity<fuzz::AllTypes>(), data[0],
                    [&]<class T>(std::type_identity<T>) {
                        check<T>(fuzz::text_of(data + 1, size - 1));
                    });
    return 0;
}
