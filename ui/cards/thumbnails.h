// Small pictures of model files for the start page. A file is read and its slits are cut on another
// thread; it is drawn when the window has nothing else to do; the picture is kept on disk, so that
// the next start has it at once.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QThreadPool>

#include <deque>
#include <memory>

namespace fff {
struct Analysis;
}

namespace fff::ui {

class OffscreenPainter;

class Thumbnails : public QObject
{
    Q_OBJECT
public:
    /// size    of a picture, device-independent px
    /// folder  where pictures are kept; empty: the person's cache
    explicit Thumbnails(const QSize &size, const QString &folder = {}, QObject *parent = nullptr);
    ~Thumbnails() override;

    /// In the theme's colours as they are now. Answered by ready(), at once when it is kept.
    void request(const QString &path, double pixelRatio);
    /// What was not begun yet is not wanted any more.
    void clear();

Q_SIGNALS:
    /// The picture is null where nothing can be drawn (no OpenGL). Not for a file that is no model.
    void ready(const QString &path, const QImage &picture, int sectionCount);

private:
    struct Job
    {
        QString path, kept; // kept: where its picture is, or will be
        double pixelRatio = 1.0;
        std::shared_ptr<const Analysis> analysis; // when it is read
    };

    bool takeKept(const Job &job);
    void readNext();
    void wasRead(Job job);
    void drawNext();

    QSize m_size;
    QString m_folder;
    std::deque<Job> m_toRead, m_toDraw;
    bool m_isReading = false, m_isDrawing = false;
    std::unique_ptr<OffscreenPainter> m_painter; // while there is something to draw
    QThreadPool m_reader;                        // last: waits for its thread before the rest goes
};

} // namespace fff::ui
