#include "ui/view/steps_page.h"

#include "core/session/section_names.h"
#include "ui/view/steps_page_data.h"

#include <QCoreApplication>
#include <QFile>
#include <QImageWriter>
#include <QLocale>

#include <map>

namespace fff::ui {

namespace {

struct StepsPageTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::StepsPage)
};

const Vec2 kPictureSize(480.0, 320.0); // px: as wide as a phone's screen
constexpr int kQuality = 72;           // of a JPEG: its digits are still sharp

/// "data:image/jpeg;base64,…", or of a PNG where Qt has no JPEG. Empty when neither can be written.
QByteArray addressOf(const QImage &image)
{
    for (const char *format : {"jpeg", "png"}) {
        QBuffer bytes;
        bytes.open(QIODevice::WriteOnly);
        QImageWriter writer(&bytes, format);
        if (format[0] == 'j')
            writer.setQuality(kQuality);
        if (writer.write(image))
            return "data:image/" + QByteArray(format) + ";base64," + bytes.data().toBase64();
    }
    return {};
}

QByteArray resource(const char *name)
{
    QFile file(QStringLiteral(":/steps_page/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Where nothing in it ends the element.
QByteArray scriptOf(QByteArray code)
{
    return "<script>\n" + code.replace("</script", "<\\/script").replace("<!--", "<\\!--") +
           "</script>\n";
}

/// three.js with its licence, and our own code.
QByteArray scripts()
{
    QByteArray own;
    for (const char *name :
         {"shapes.js", "playback.js", "model.js", "marks.js", "fingers.js", "page.js"})
        own += resource(name);
    return scriptOf(
               "/*\nthree.js, https://threejs.org\nCopyright © 2010–2019 three.js authors\n\n" +
               resource("mit.txt") + "*/\n" + resource("three.min.js") + '\n') +
           scriptOf(own);
}

/// {{name}} of the template, each once; what is put in is not looked at again.
QByteArray filledIn(const QByteArray &page, const std::map<QByteArray, QByteArray> &parts)
{
    QByteArray filled;
    qsizetype done = 0;
    for (qsizetype at = page.indexOf("{{"); at >= 0; at = page.indexOf("{{", done)) {
        const qsizetype end = page.indexOf("}}", at);
        Q_ASSERT(end > at && parts.contains(page.mid(at + 2, end - at - 2)));
        filled += page.mid(done, at - done) + parts.at(page.mid(at + 2, end - at - 2));
        done = end + 2;
    }
    return filled + page.mid(done);
}

QByteArray escaped(const QString &text)
{
    return text.toHtmlEscaped().toUtf8();
}

} // namespace

StepsPage::StepsPage(StepPictures &pictures, const Options &options, const Camera &looking)
    : m_pictures(pictures), m_steps(pictures.steps()), m_options(options), m_looking(looking)
{
}

bool StepsPage::hasModel()
{
    return QFile::exists(QStringLiteral(":/steps_page/three.min.js"));
}

bool StepsPage::makePiece(int index)
{
    if (!m_pictures.isUsable())
        return hasModel();
    const QImage image = m_pictures.step(index, StepPictures::Fit::Step, kPictureSize, 1.0);
    if (image.isNull())
        return false;
    m_images.push_back(addressOf(image));
    return !m_images.back().isEmpty();
}

/// What the page has where it does not show the model: a sentence and a picture for each step.
QString StepsPage::picturesPart() const
{
    QString part;
    const auto note = [&part](const QString &text) {
        part += QStringLiteral("<p class=\"note\">%1</p>\n").arg(text.toHtmlEscaped());
    };
    if (hasModel())
        note(StepsPageTexts::tr("This browser does not show the model in 3D. Here is what to do, "
                                "step by step."));
    if (m_images.empty())
        note(StepsPageTexts::tr(
            "There are no pictures: none could be made on the display of the computer that wrote "
            "this page."));
    part += QStringLiteral("<ol>\n");
    for (int i = 0; i < m_steps.playback.stepCount(); ++i) {
        const QString title = stepTitle(m_steps, i).toHtmlEscaped();
        part += QStringLiteral("<li>");
        if (!m_images.empty())
            part += QStringLiteral("<img alt=\"\" width=\"%1\" height=\"%2\" src=\"%3\">")
                        .arg(kPictureSize.x())
                        .arg(kPictureSize.y())
                        .arg(QString::fromLatin1(m_images[static_cast<std::size_t>(i)]));
        part += QStringLiteral("<p><b>") + title + QStringLiteral("</b> ") +
                stepSentence(m_steps, i).toHtmlEscaped() + QStringLiteral("</p></li>\n");
    }
    return part + QStringLiteral("</ol>\n");
}

/// A row for each part, in the order of their numbers.
QString StepsPage::tablePart() const
{
    const Analysis &analysis = *m_steps.analysis;
    const Model &model = analysis.model;
    const auto row = [](const char *cell, const QStringList &texts) {
        QString cells;
        for (const QString &text : texts)
            cells += QStringLiteral("<%1>%2</%1>").arg(QLatin1String(cell), text.toHtmlEscaped());
        return QStringLiteral("<tr>") + cells + QStringLiteral("</tr>\n");
    };
    QString table = QStringLiteral("<thead>\n") +
                    row("th", {StepsPageTexts::tr("Number"), StepsPageTexts::tr("Name"),
                               StepsPageTexts::tr("Size"), StepsPageTexts::tr("Stock")}) +
                    QStringLiteral("</thead>\n<tbody>\n");
    for (const Part &part : makeParts(model, analysis.assembly, analysis.bodies))
        table += row(
            "td", {QLocale().toString(part.number),
                   sectionName(model, model.ref(static_cast<std::size_t>(part.section))),
                   StepsPaper::sizeText(bounds(part.outline.region.outer).size(), m_options.unit),
                   StepsPaper::stockText(*model.document.find(part.stock), m_options)});
    return table + QStringLiteral("</tbody>\n");
}

QByteArray StepsPage::take()
{
    const QString facts = StepsPaper::factsText(m_steps, m_options);
    const QString turning =
        StepsPageTexts::tr("Drag to turn the model, pinch or scroll to zoom, tap twice to see all "
                           "of it.");
    const QString play = StepsPageTexts::tr("Play");
    const std::map<std::string, QString> texts{{"facts", facts},
                                               {"finished", StepsPageTexts::tr("Finished")},
                                               {"pause", StepsPageTexts::tr("Pause")},
                                               {"play", play}};
    return filledIn(
        resource("template.html"),
        {{"language", escaped(QLocale().bcp47Name())},
         {"title", escaped(m_options.title)},
         {"facts", escaped(facts)},
         {"style", resource("page.css")},
         {"turning", escaped(turning)},
         {"slider", escaped(StepsPageTexts::tr("Step"))},
         {"previous", escaped(StepsPageTexts::tr("Previous step"))},
         {"play", escaped(play)},
         {"next", escaped(StepsPageTexts::tr("Next step"))},
         {"pictures", picturesPart().toUtf8()},
         {"parts", escaped(StepsPageTexts::tr("Parts"))},
         {"table", tablePart().toUtf8()},
         {"data", hasModel() ? QByteArray::fromStdString(stepsPageData(m_steps, texts, m_looking))
                             : QByteArray("{}\n")},
         {"scripts", hasModel() ? scripts() : QByteArray()}});
}

} // namespace fff::ui
