// The texts of the sources, as translators get them.
#pragma once

#include <QFile>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QXmlStreamReader>

#include <vector>

namespace fff::test {

inline const QString kSources = QStringLiteral(FFF_SOURCES);

struct TranslatedText
{
    QString context, source, translation;
    bool isUnfinished = false;
};

/// Of a .ts file; none if it cannot be read.
inline std::vector<TranslatedText> textsOf(const QString &path)
{
    std::vector<TranslatedText> texts;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return texts;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const auto name = xml.name();
        if (name == u"name") {
            context = xml.readElementText();
        } else if (name == u"message") {
            texts.push_back({context, {}, {}, false});
        } else if (name == u"source") {
            texts.back().source = xml.readElementText();
        } else if (name == u"translation") {
            texts.back().isUnfinished = xml.attributes().hasAttribute(QStringLiteral("type"));
            texts.back().translation =
                xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
        }
    }
    return texts;
}

/// Brings what the sources say into a .ts file, as translations/update does. Why not, if it failed.
inline QString bringTexts(const QString &into)
{
    QProcess lupdate;
    lupdate.setWorkingDirectory(kSources);
    QStringList arguments;
    for (const char *alias :
         {"QT_TRANSLATE_NOOP+=FFF_TEXT", "QT_TRANSLATE_N_NOOP+=FFF_TEXT_OF_MANY"})
        arguments += {QStringLiteral("-tr-function-alias"), QLatin1String(alias)};
    for (const char *word :
         {"-I", ".", "ui", "app", "core", "-locations", "none", "-no-obsolete", "-silent", "-ts"})
        arguments += QLatin1String(word);
    lupdate.start(QStringLiteral(FFF_LUPDATE), arguments << into);
    if (!lupdate.waitForFinished(-1))
        return lupdate.errorString();
    return lupdate.exitCode() == 0 ? QString()
                                   : QString::fromLocal8Bit(lupdate.readAllStandardError());
}

} // namespace fff::test
