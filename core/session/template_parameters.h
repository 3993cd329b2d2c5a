// What commands of templates are told. Internal to core/session.
#pragma once

#include "core/interaction/commands.h"
#include "core/model/document.h"

namespace fff {

/// Errors of all: BadValue, place = the key, with what was found and what was expected.
Result<bool> truthOf(const CommandParameters &parameters, const char *key, bool otherwise);
Result<int> wholeOf(const CommandParameters &parameters, const char *key, int otherwise, int least,
                    int most);
/// By its name; without the key the last one.
Result<Template> templateOf(const Document &document, const CommandParameters &parameters,
                            const char *key = "template");

} // namespace fff
