#include "ui/files/new_model.h"

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "ui/settings/settings.h"

#include <utility>

namespace fff::ui {

Document newModel()
{
    const QString path = settings().newModelFile();
    if (path.isEmpty())
        return newDocument();
    Result<io::LoadedDocument> loaded = io::readDocument(path);
    if (loaded)
        return std::move(loaded->document);
    qWarning("New models are empty: %s", qPrintable(io::errorText(loaded.error())));
    return newDocument();
}

} // namespace fff::ui
