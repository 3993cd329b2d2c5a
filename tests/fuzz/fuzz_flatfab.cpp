// Any bytes as a model of FlatFab. If this stops, an old model found on the net takes the window
// down, or one that opens cannot be saved.
#include "core/io/error_text.h"
#include "core/io/flatfab_format.h"
#include "tests/fuzz/properties.h"

using namespace fff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    const Result<io::LoadedDocument> loaded = io::readFlatfab(bytes, "input.txt");
    if (!loaded) {
        fuzz::requireClear(loaded.error());
        return 0;
    }
    for (const Warning &warning : loaded->warnings)
        fuzz::require(!io::warningText(warning).isEmpty(), "a warning has words");
    fuzz::requireRoundTrip(loaded->document);
    return 0;
}
