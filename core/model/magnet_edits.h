// A section as a magnet: meshes near its plane are pulled into it, all of them alike.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

#include <optional>

namespace fff {

/// There is a mesh that is not locked.
bool canPullTemplates(const Document &document);
/// How far it reaches, mm, of the first mesh that it pulls; nothing: it pulls none.
std::optional<double> magnetOf(const Document &document, const SectionRef &section);
/// Of each mesh that is not locked; without a radius it pulls none of these.
/// radius  mm. Errors  as setTemplate(); UnknownReference where there is no such mesh.
Result<Document> setMagnet(Document document, const SectionRef &section,
                           std::optional<double> radius);

} // namespace fff
