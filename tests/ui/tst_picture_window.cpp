// Pictures to draw over in a real window: what a trace would make is seen before it is made, they
// come from the clipboard, are sized by a line and moved with handles.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/segment_distance.h"
#include "core/interaction/drawing_words.h"
#include "core/interaction/size_line_tool.h"
#include "core/interaction/template_tool.h"
#include "core/io/fff_format.h"
#include "core/session/copy_commands.h"
#include "core/templates/moved_template.h"
#include "tests/core/interaction/template_desk.h"
#include "tests/test_program.h"
#include "tests/told.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/base/message_bar.h"
#include "ui/base/sentence_label.h"

#include <QBuffer>
#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>
#include <QUrl>

#include <cmath>

using namespace fff;
using namespace fff::ui;

namespace {

QByteArray encoded(const QImage &image, const char *format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, format))
        qFatal("no picture");
    return bytes;
}

QImage someImage(int width = 40, int height = 30)
{
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Qt::white);
    for (int x = 8; x < width - 8; ++x)
        for (int y = 8; y < height - 8; ++y)
            image.setPixel(x, y, qRgb(20, 30, 40));
    return image;
}

const QByteArray kSvg = "<svg xmlns='http://www.w3.org/2000/svg' width='60mm' height='40mm' "
                        "viewBox='0 0 60 40'><path d='M0 0h60v40h-60z'/></svg>";

} // namespace

class TestPictureWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void outlinesAreSeenWhileTraceIsOpen();
    void theyFollowTheNumbersAndTheTemplate();
    void tracedIsWhatWasSeen();
    void holesWantASection();
    void tooManyForSectionsIsSaid();
    void pastedPicturesAreTemplates_data();
    void pastedPicturesAreTemplates();
    void sectionsInTheClipboardComeFirst();
    void whatCannotBePastedIsSaid_data();
    void whatCannotBePastedIsSaid();
    void aLineSaysHowLargeItIs();
    void handlesComeWithAClickOnItsRow();
    void theListFollowsTheHand();

private:
    template <class Widget>
    Widget *find(const char *name)
    {
        return m_window->findChild<Widget *>(QLatin1String(name));
    }
    const Template &one() const { return *session().committed().document.templates.back(); }
    std::size_t templates() const { return session().committed().document.templates.size(); }
    void add(const Template &one)
    {
        session().commit(QStringLiteral("Add"),
                         addTemplate(session().committed().document, one).value());
        bench().run(QStringLiteral("template.toGround"));
        auto *dock = find<QDockWidget>("templatesDock");
        dock->show();
        dock->raise();
        QTRY_VERIFY(find<QTreeWidget>("templateTree")->isVisible());
    }
    void clickRow(int row)
    {
        auto *tree = find<QTreeWidget>("templateTree");
        const QRect place = tree->visualItemRect(tree->topLevelItem(row));
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, QPoint(60, place.center().y()));
    }
    void push(const char *button)
    {
        auto *found = find<QPushButton>(button);
        QVERIFY2(found && found->isVisible() && found->isEnabled(), button);
        QTest::mouseClick(found, Qt::LeftButton);
    }
    /// The heading that folds the numbers of a trace.
    void foldTrace()
    {
        for (QPushButton *title :
             m_window->findChildren<QPushButton *>(QStringLiteral("groupTitle")))
            if (title->text() == QLatin1String("Trace"))
                QTest::mouseClick(title, Qt::LeftButton);
    }
    void type(const char *field, const QString &text)
    {
        auto *edit = find<QDoubleSpinBox>(field);
        QVERIFY2(edit && edit->isVisible(), field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    /// That are drawn over the picture now.
    std::vector<Polygon> outlines()
    {
        const Signs signs = bench().tracedSigns();
        const auto *found = signs.find<sign::Outlines>();
        return found ? *found->lines : std::vector<Polygon>();
    }
    QString said()
    {
        const auto *row = find<QLabel>("traceOutlines");
        return row ? row->text() : QString();
    }
    const GizmoMarks *marks() { return interaction().overlay().find<GizmoMarks>(); }
    QPoint tip(int axis)
    {
        const GizmoLook look(marks()->gizmo, interaction().camera(),
                             Vec2(m_view->width(), m_view->height()));
        return {static_cast<int>(look.tip(axis).x()), static_cast<int>(look.tip(axis).y())};
    }
    void paste(QMimeData *data)
    {
        QGuiApplication::clipboard()->setMimeData(data);
        m_view->setFocus();
        key(Qt::Key_V, Qt::ControlModifier);
    }
};

// Wrong: what is drawn over by hand is covered with outlines, or a trace is a leap in the dark.
void TestPictureWindow::outlinesAreSeenWhileTraceIsOpen()
{
    add(test::pictureTemplate(test::discPicture()));
    clickRow(0);
    QVERIFY(outlines().empty());
    foldTrace();
    QTRY_COMPARE(outlines().size(), std::size_t(1));
    QCOMPARE(said(), QStringLiteral("1"));
    const Polygon outline = outlines().front();
    for (const Vec2 &p : outline)
        QVERIFY(std::abs(p.norm() - 70.0) < 1.0); // px about the middle
    foldTrace();
    QVERIFY(outlines().empty());
    foldTrace();
    QTRY_COMPARE(outlines().size(), std::size_t(1));
    auto *tree = find<QTreeWidget>("templateTree");
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_Space); // hidden
    QVERIFY(outlines().empty());
    QTest::keyClick(tree, Qt::Key_Space);
    QTRY_COMPARE(outlines().size(), std::size_t(1));
    find<QDockWidget>("templatesDock")->hide();
    QVERIFY(outlines().empty());
}

void TestPictureWindow::theyFollowTheNumbersAndTheTemplate()
{
    // Three shades: the threshold decides how much of it counts.
    auto picture = std::make_shared<TemplatePicture>(*test::discPicture(200, 80.0));
    for (int y = 70; y < 130; ++y)
        for (int x = 70; x < 130; ++x)
            for (int channel : {0, 1, 2})
                picture->rgba[static_cast<std::size_t>(4 * (200 * y + x) + channel)] = 120;
    add(test::pictureTemplate(picture));
    clickRow(0);
    foldTrace();
    QTRY_VERIFY(!outlines().empty());
    type("traceThreshold.field", QStringLiteral("20"));
    QTRY_COMPARE(outlines().size(), std::size_t(2)); // the disc, and a hole in it
    type("traceThreshold.field", QStringLiteral("80"));
    QTRY_COMPARE(outlines().size(), std::size_t(1));
    // On the way of the slider, and only what it ends at.
    auto *slider = find<QSlider>("traceThresholdSlider");
    for (int i = 0; i < 12; ++i)
        QTest::keyClick(slider, i % 2 == 0 ? Qt::Key_PageDown : Qt::Key_PageUp);
    type("traceThreshold.field", QStringLiteral("20"));
    QTRY_COMPARE(outlines().size(), std::size_t(2));
    bench().run(QStringLiteral("template.set"), {{"x", "40"}, {"size", "50"}});
    const Signs signs = bench().tracedSigns();
    const Similarity &placement = signs.find<sign::Outlines>()->placement;
    QCOMPARE(placement.shift.x(), 40.0);
    QCOMPARE(placement.scale, 0.25);
    QCOMPARE(outlines().size(), std::size_t(2));
}

// Wrong: another outline is cut than the one that was looked at.
void TestPictureWindow::tracedIsWhatWasSeen()
{
    add(test::pictureTemplate(test::pictureOf(260, 180, [](double x, double y) {
        return std::hypot(x - 80, y - 90) < 60 || (x > 170 && x < 240 && y > 30 && y < 150);
    })));
    clickRow(0);
    foldTrace();
    type("traceSmoothing.field", QStringLiteral("80"));
    QTRY_COMPARE(outlines().size(), std::size_t(2));
    const std::vector<Polygon> seen = outlines();
    push("flat.sections");
    QTRY_COMPARE(count(), std::size_t(2));
    // It is said, and what it was made of does not cover its points.
    QVERIFY(
        find<SentenceLabel>("statusSentence")->text().startsWith(QStringLiteral("Made 2 section")));
    QVERIFY(outlines().empty());
    const Document made = session().committed().document;
    for (std::size_t i = 0; i < 2; ++i) {
        const Section &section = *made.sections[i];
        // Every place that was seen is on the outline that is cut.
        const Polygon cut = section.shape->contour().polygon(0.001);
        for (const Vec2 &p : seen[i]) {
            const Vec2 at = section.frame.toLocal(
                (*worldPlacement(one(), session().committed()))({p.x(), p.y(), 0.0}));
            double nearest = 1e9;
            for (std::size_t k = 0; k < cut.size(); ++k)
                nearest =
                    std::min(nearest, distanceToSegment(at, cut[k], cut[(k + 1) % cut.size()]));
            QVERIFY2(nearest < 0.002, qPrintable(QString::number(nearest)));
        }
    }
    // The same as the command makes of the same numbers.
    const int threshold = find<QSlider>("traceThresholdSlider")->value();
    session().history()->undo();
    bench().run(QStringLiteral("template.trace"),
                {{"threshold", std::to_string(threshold)}, {"smoothing", "80"}});
    const Document again = session().committed().document;
    QCOMPARE(again.sections.size(), made.sections.size());
    for (std::size_t i = 0; i < 2; ++i) {
        QVERIFY(*again.sections[i]->shape == *made.sections[i]->shape);
        QVERIFY(again.sections[i]->frame == made.sections[i]->frame);
    }
}

// Wrong: a key of a parameter in place of a sentence, which stays when all is well again.
void TestPictureWindow::holesWantASection()
{
    add(test::pictureTemplate(test::pictureOf(
        260, 180, [](double x, double y) { return std::hypot(x - 80, y - 90) < 60; })));
    clickRow(0);
    foldTrace();
    QTest::qWait(50); // what was unfolded is laid out
    const auto *bar = m_window->findChild<MessageBar *>();
    push("flat.holes");
    QCOMPARE(
        bar->text(),
        QStringLiteral("Select the section to cut holes in first, or place the drawing on it."));
    push("flat.engraved");
    QCOMPARE(bar->text(),
             QStringLiteral("Select the section to engrave first, or place the drawing on it."));
    QCOMPARE(count(), std::size_t(0));
    push("flat.sections");
    QTRY_COMPARE(count(), std::size_t(1));
    QVERIFY(!bar->isVisible());
}

void TestPictureWindow::tooManyForSectionsIsSaid()
{
    add(test::pictureTemplate(test::pictureOf(300, 300, [](double x, double y) {
        return std::fmod(x, 20.0) < 10.0 && std::fmod(y, 20.0) < 10.0;
    })));
    clickRow(0);
    foldTrace();
    QTRY_COMPARE(outlines().size(), std::size_t(225));
    QCOMPARE(said(), QStringLiteral("225: too many for sections"));
    push("flat.sections");
    QCOMPARE(count(), std::size_t(0));
    QCOMPARE(interaction().hint().words.text, hints::kTooManyOutlines);
}

void TestPictureWindow::pastedPicturesAreTemplates_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"pixels", "png", "jpeg", "svg", "png file", "svg file"})
        QTest::newRow(what) << QString::fromLatin1(what);
}

void TestPictureWindow::pastedPicturesAreTemplates()
{
    QFETCH(const QString, what);
    auto *data = new QMimeData;
    const bool isDrawing = what.startsWith(QLatin1String("svg"));
    QString name = QStringLiteral("Pasted picture");
    if (what.endsWith(QLatin1String("file"))) {
        name = QStringLiteral("silhouette");
        const QString path = m_folder->filePath(isDrawing ? QStringLiteral("silhouette.svg")
                                                          : QStringLiteral("silhouette.png"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(isDrawing ? kSvg : encoded(someImage(), "png"));
        file.close();
        data->setUrls({QUrl::fromLocalFile(path)});
        data->setText(path); // as file managers do
    } else if (what == QLatin1String("pixels")) {
        data->setImageData(someImage());
    } else if (isDrawing) {
        data->setData(QStringLiteral("image/svg+xml"), kSvg);
        data->setImageData(someImage(3, 3)); // which says less
    } else {
        data->setData(QStringLiteral("image/") + what, encoded(someImage(), qPrintable(what)));
        data->setHtml(QStringLiteral("<img src='https://example.org/a.png'>"));
    }
    const Document before = session().committed().document;
    const int begun = steps();
    paste(data);
    QTRY_COMPARE(templates(), std::size_t(1));
    QCOMPARE(QString::fromStdString(one().name), name);
    QVERIFY(isDrawing ? one().curves != nullptr : one().picture != nullptr);
    if (!isDrawing)
        QCOMPARE(one().picture->width, 40);
    QVERIFY(session().committed().document.findBlob(one().blob));
    QCOMPARE(steps(), begun + 1);
    QVERIFY(find<QDockWidget>("templatesDock")->isVisible());
    // Once more it is another one.
    m_view->setFocus();
    key(Qt::Key_V, Qt::ControlModifier);
    QTRY_COMPARE(templates(), std::size_t(2));
    QCOMPARE(QString::fromStdString(one().name), name + QStringLiteral(" 2"));
    session().history()->undo();
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(before));
}

void TestPictureWindow::sectionsInTheClipboardComeFirst()
{
    drawFirst();
    bench().run(QStringLiteral("edit.selectAll"));
    m_view->setFocus();
    key(Qt::Key_C, Qt::ControlModifier);
    const QByteArray model = QGuiApplication::clipboard()->mimeData()->text().toUtf8();
    for (const bool isTyped : {true, false}) {
        auto *data = new QMimeData;
        data->setImageData(someImage());
        data->setData(QStringLiteral("image/png"), encoded(someImage(), "png"));
        if (isTyped)
            data->setData(QStringLiteral("application/x-flatfitfab+json"), model);
        else
            data->setText(QString::fromUtf8(model));
        const std::size_t before = count();
        paste(data);
        QCOMPARE(count(), before + 1);
        QCOMPARE(templates(), std::size_t(0));
    }
    // A text that is no model leaves the picture what is meant.
    auto *data = new QMimeData;
    data->setImageData(someImage());
    data->setText(QStringLiteral("a picture"));
    paste(data);
    QTRY_COMPARE(templates(), std::size_t(1));
}

void TestPictureWindow::whatCannotBePastedIsSaid_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"too large", "damaged", "missing file"})
        QTest::newRow(what) << QString::fromLatin1(what);
}

void TestPictureWindow::whatCannotBePastedIsSaid()
{
    QFETCH(const QString, what);
    auto *data = new QMimeData;
    if (what == QLatin1String("too large")) {
        QImage image(9000, 8000, QImage::Format_Mono); // a bit a pixel: it is there cheaply
        image.fill(0);
        data->setImageData(image);
    } else if (what == QLatin1String("damaged")) {
        data->setData(QStringLiteral("image/png"), encoded(someImage(), "png").left(60));
    } else {
        data->setUrls({QUrl::fromLocalFile(m_folder->filePath(QStringLiteral("gone.png")))});
    }
    const int begun = steps();
    paste(data);
    auto *messages = find<MessageBar>("messageBar");
    QTRY_VERIFY(messages->isVisible());
    const QString text = messages->text();
    QVERIFY2(text.contains(what == QLatin1String("missing file")
                               ? QStringLiteral("gone.png")
                               : QStringLiteral("Pasted picture")),
             qPrintable(text));
    QCOMPARE(steps(), begun);
    QCOMPARE(templates(), std::size_t(0));
}

// Wrong: the size of a scan would have to be worked out on paper.
void TestPictureWindow::aLineSaysHowLargeItIs()
{
    add(test::pictureTemplate(test::discPicture())); // 100 mm, its disc 70
    clickRow(0);
    key(Qt::Key_Escape);
    const Document before = session().committed().document;
    const int begun = steps();
    push("templateSizeByLine");
    QVERIFY(dynamic_cast<const SizeLineTool *>(interaction().tool()));
    QVERIFY(find<QPushButton>("templateSizeByLine")->isChecked());
    QTRY_VERIFY(m_view->hasFocus());
    const Vec3 middle = one().frame.origin;
    const QPoint from = onScreen(middle - Vec3(35, 0, 0)), to = onScreen(middle + Vec3(35, 0, 0));
    drag({from, (from + to) / 2, to});
    const auto *line = interaction().overlay().find<sign::Line>();
    QVERIFY(line);
    const Vec3 a = one().placement().inverse()(line->points.front());
    const Vec3 b = one().placement().inverse()(line->points.back());
    auto *field = find<QDoubleSpinBox>("canvasWanted");
    QTRY_VERIFY(field->isVisible());
    // Not of each number on the way to it: 2, 21, 210.
    std::vector<double> seen;
    const auto watch =
        connect(&session(), &Session::modelChanged, this, [&](const Model &, const Model &now) {
            const Similarity there = now.document.templates.back()->placement();
            seen.push_back((there(b) - there(a)).norm());
        });
    key(Qt::Key_2);
    QTRY_VERIFY(field->hasFocus());
    QTest::keyClicks(field, QStringLiteral("10"));
    QTRY_VERIFY(session().hasPreview());
    disconnect(watch);
    QCOMPARE(seen.size(), std::size_t(1));
    QVERIFY(std::abs(seen.front() - 210.0) < 1e-9);
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_VERIFY(!interaction().tool());
    QVERIFY(!find<QPushButton>("templateSizeByLine")->isChecked());
    QCOMPARE(steps(), begun + 1);
    const Similarity placement = one().placement();
    QVERIFY(std::abs((placement(b) - placement(a)).norm() - 210.0) < 1e-9);
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(before));
    // The same button puts it away, and so does Esc.
    push("templateSizeByLine");
    push("templateSizeByLine");
    QVERIFY(!interaction().tool());
    push("templateSizeByLine");
    key(Qt::Key_Escape);
    QTRY_VERIFY(!interaction().tool());
}

void TestPictureWindow::handlesComeWithAClickOnItsRow()
{
    add(test::pictureTemplate(test::discPicture()));
    QVERIFY(!interaction().tool()); // who adds one may just as well draw over it at once
    clickRow(0);
    QTRY_VERIFY(marks());
    const Document before = session().committed().document;
    const int begun = steps();
    const QPoint at = tip(0);
    auto *x = find<QDoubleSpinBox>("templateX");
    const double was = x->value();
    move(at);
    press(at);
    move(at + QPoint(20, 0));
    move(at + QPoint(45, 0));
    QTRY_VERIFY(session().hasPreview());
    QTRY_VERIFY(x->value() > was + 1.0); // on the way
    QCOMPARE(steps(), begun);
    release(at + QPoint(45, 0));
    QCOMPARE(steps(), begun + 1);
    QVERIFY(std::abs(x->value() - one().frame.origin.x()) < 1e-3);
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(before));
    QVERIFY(marks());
    // Clicking elsewhere ends it.
    click({20, m_view->height() - 120});
    QVERIFY(!interaction().tool());
    // What is locked has none.
    auto *tree = find<QTreeWidget>("templateTree");
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_L);
    clickRow(0);
    QVERIFY(!interaction().tool());
    QVERIFY(!find<QPushButton>("templateHandles")->isEnabled());
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_L);
    clickRow(0);
    QTRY_VERIFY(marks());
    // Esc in the list, too.
    QVERIFY(tree->hasFocus());
    QTest::keyClick(tree, Qt::Key_Escape);
    QVERIFY(!interaction().tool());
}

void TestPictureWindow::theListFollowsTheHand()
{
    add(test::pictureTemplate(test::discPicture()));
    add(test::ballTemplate());
    clickRow(0);
    QTRY_VERIFY(marks());
    const auto of = [this] {
        const auto *tool = dynamic_cast<const TemplateTool *>(interaction().tool());
        return tool ? tool->of() : TemplateId();
    };
    const auto &all = session().committed().document.templates;
    QCOMPARE(of(), all[0]->id);
    auto *tree = find<QTreeWidget>("templateTree");
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_Down);
    QCOMPARE(of(), all[1]->id);
    QVERIFY(marks()->gizmo.isInSpace);
    type("canvasTurn", QStringLiteral("30"));
    QVERIFY(std::abs(session().committed().document.templates[1]->frame.x.x() -
                     std::cos(radians(30.0))) < 1e-9);
    QCOMPARE(session().history()->undoText(), QStringLiteral("Turn template Ball"));
}

FFF_TEST_WITH(TestPictureWindow, runInWindowProgram<TestPictureWindow>)
#include "tst_picture_window.moc"
