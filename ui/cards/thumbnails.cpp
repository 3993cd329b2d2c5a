#include "ui/cards/thumbnails.h"

#include "core/analysis/analysis.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "ui/base/theme.h"
#include "ui/settings/places.h"
#include "ui/view/offscreen_image.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QImageWriter>
#include <QSaveFile>
#include <QTimer>

namespace fff::ui {

namespace {

// Counts up when pictures look different, so that old ones are not used any more.
constexpr int kLook = 3;
// So many times as large a view would have lines of a pixel.
constexpr double kLineShare = 2.5;
// So many times as many pixels each way as the screen shows: thin lines are steps otherwise, and a
// window that is moved to a finer screen has them already.
constexpr double kFineness = 2.0;

const QString kSections = QStringLiteral("Sections"); // a text in the picture's file

QString ownFolder()
{
    return places().cache + QStringLiteral("/thumbnails");
}

/// Another one for another state of the file, another theme, another size.
QString nameOf(const QString &path, const QSize &size, double pixelRatio)
{
    const QFileInfo info(path);
    const QStringList facts = {
        info.absoluteFilePath(), QString::number(info.size()),
        // A file inside the program has no time of its own.
        path.startsWith(u':') ? QStringLiteral(FFF_VERSION)
                              : info.lastModified().toString(Qt::ISODateWithMs),
        QString::number(size.width()), QString::number(size.height()), QString::number(pixelRatio),
        theme().isDark ? QStringLiteral("dark") : QStringLiteral("light"),
        theme().isHighContrast ? QStringLiteral("contrast") : QString(), QString::number(kLook)};
    const QByteArray key = facts.join(u'\n').toUtf8();
    return QString::fromLatin1(QCryptographicHash::hash(key, QCryptographicHash::Sha1).toHex()) +
           QStringLiteral(".png");
}

/// Null for what is no model.
std::shared_ptr<const Analysis> analysisOf(const QString &path)
{
    const Result<io::LoadedDocument> loaded = io::readDocument(path);
    if (!loaded)
        return nullptr;
    AnalysisCaches caches;
    auto analysis = std::make_shared<Analysis>(analyse(Model(evaluate(loaded->document)), caches));
    prepareDrawing(*analysis);
    return analysis;
}

/// Losing a picture of the cache costs a moment, nothing else: failures are not told.
void keep(const QImage &picture, const QString &path)
{
    if (!QDir().mkpath(QFileInfo(path).absolutePath()))
        return;
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && QImageWriter(&file, "png").write(picture))
        file.commit();
}

} // namespace

Thumbnails::Thumbnails(const QSize &size, const QString &folder, QObject *parent)
    : QObject(parent), m_size(size), m_folder(folder.isEmpty() ? ownFolder() : folder)
{
    m_reader.setMaxThreadCount(1);
}

Thumbnails::~Thumbnails()
{
    m_reader.waitForDone();
}

void Thumbnails::clear()
{
    m_toRead.clear();
    m_toDraw.clear();
}

void Thumbnails::request(const QString &path, double pixelRatio)
{
    Job job;
    job.path = path;
    job.pixelRatio = pixelRatio;
    job.kept = m_folder + u'/' + nameOf(path, m_size, pixelRatio);
    if (takeKept(job))
        return;
    m_toRead.push_back(std::move(job));
    readNext();
}

bool Thumbnails::takeKept(const Job &job)
{
    QImage picture(job.kept);
    if (picture.isNull())
        return false;
    picture.setDevicePixelRatio(kFineness * job.pixelRatio);
    Q_EMIT ready(job.path, picture, picture.text(kSections).toInt());
    return true;
}

void Thumbnails::readNext()
{
    if (m_isReading || m_toRead.empty())
        return;
    m_isReading = true;
    m_reader.start([this, job = std::move(m_toRead.front())]() mutable {
        job.analysis = analysisOf(job.path);
        QMetaObject::invokeMethod(
            this, [this, done = std::move(job)] { wasRead(done); }, Qt::QueuedConnection);
    });
    m_toRead.pop_front();
}

void Thumbnails::wasRead(Job job)
{
    m_isReading = false;
    if (job.analysis)
        m_toDraw.push_back(std::move(job));
    readNext();
    if (!m_isDrawing && !m_toDraw.empty()) {
        m_isDrawing = true;
        QTimer::singleShot(0, this, &Thumbnails::drawNext);
    }
}

/// One at a time, with all that waits for the window in between.
void Thumbnails::drawNext()
{
    m_isDrawing = false;
    if (!m_toDraw.empty()) {
        const Job job = std::move(m_toDraw.front());
        m_toDraw.pop_front();
        if (!m_painter)
            m_painter = std::make_unique<OffscreenPainter>();
        const Vec2 size(m_size.width(), m_size.height());
        const Scene scene = sceneOf(*job.analysis);
        // Lines are as thin as in a larger picture that was made small.
        const Vec2 drawn = kLineShare * size;
        const double pixelRatio = kFineness * job.pixelRatio;
        QImage picture = m_painter->paint(scene, cameraFor(scene, "iso1", drawn), drawn,
                                          pixelRatio / kLineShare, theme().viewStyle());
        picture.setDevicePixelRatio(pixelRatio);
        const int count = static_cast<int>(job.analysis->model.sectionCount());
        if (!picture.isNull()) {
            picture.setText(kSections, QString::number(count));
            keep(picture, job.kept);
        }
        Q_EMIT ready(job.path, picture, count);
    }
    if (!m_toDraw.empty()) {
        m_isDrawing = true;
        QTimer::singleShot(0, this, &Thumbnails::drawNext);
    } else if (!m_isReading) {
        m_painter.reset();
    }
}

} // namespace fff::ui
