// The skin over the model, as it is drawn in the view, and how far it has come.
#pragma once

#include "ui/view/template_painter.h"

#include <QObject>
#include <QString>

#include <optional>

namespace fff {
class Scheduler;
} // namespace fff

namespace fff::ui {

class Workbench;

/// A few words, "Skin" alone where it is there: how far it has come, that there is none, or why
/// not; empty where nobody asks.
QString skinState(const Scheduler &scheduler);
/// What there is to say of it in a sentence or two.
QString skinDetails(const Scheduler &scheduler);

class SkinPicture : public QObject
{
    Q_OBJECT
public:
    explicit SkinPicture(Workbench &bench, QObject *parent = nullptr);

    /// Nothing: nobody asks, or there is none. Until there is a newer one that of before.
    std::optional<SceneTemplate> shown() const;

Q_SIGNALS:
    void changed();

private:
    Workbench &m_bench;
};

} // namespace fff::ui
