#include "core/session/journal.h"

#include "core/io/fff_format.h"

#include <QCryptographicHash>

namespace fff {

Q_LOGGING_CATEGORY(journal, "flatfitfab.journal", QtWarningMsg)

QByteArray digestOf(const Document &document)
{
    const Result<std::string> bytes = io::writeFff(document);
    return bytes ? QCryptographicHash::hash(QByteArray::fromStdString(*bytes),
                                            QCryptographicHash::Sha1)
                       .toHex()
                       .left(12)
                 : QByteArray("unwritable");
}

} // namespace fff
