// What a trace of a picture would make, worked out beside the window and drawn over the picture:
// the newest numbers count, what was begun for others is given up.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/geometry/polygon.h"
#include "core/interaction/template_drawing.h"
#include "core/session/latest_job.h"

#include <QPointer>

#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

namespace fff::ui {

class Workbench;

class TracePreview : public QObject
{
    Q_OBJECT
public:
    explicit TracePreview(Workbench &bench, QObject *parent = nullptr);
    ~TracePreview() override;

    /// Of this picture, with these numbers, from now on. What was drawn before stays until they are
    /// worked out, if it is of the same picture.
    void show(const Template &one, const PictureTrace &trace);
    /// Nothing is drawn any more.
    void hide();
    /// With just these numbers, if that is known by now; else null.
    TracedPicturePointer known(const Template &one, const PictureTrace &trace) const;

Q_SIGNALS:
    /// What is known is another one.
    void changed();

private:
    struct Asked
    {
        TemplatePicturePointer picture; // null: what was kept for it can go
        PictureTrace trace;
        std::stop_token stop;
    };
    struct Seen
    {
        TracedPicturePointer traced; // null: given up
        std::shared_ptr<const std::vector<Polygon>> lines;
    };
    void ask(TemplatePicturePointer picture, const PictureTrace &trace);
    void take(std::uint64_t revision, Seen seen);

    QPointer<Workbench> m_bench; // may go first, with the window
    TemplateId m_of;
    TemplatePicturePointer m_picture; // that is asked about; null: none
    PictureTrace m_trace;
    std::uint64_t m_revision = 0;
    std::stop_source m_stop; // of what runs
    Seen m_seen;
    LatestJob<Asked, Seen> m_job; // last: its destructor waits
};

} // namespace fff::ui
