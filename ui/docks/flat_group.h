// What can be done with a picture or a drawing that is a template: where it lies, and what its
// lines become.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/interaction/template_drawing.h"

#include <functional>
#include <tuple>
#include <vector>

namespace fff {
struct Template;
}

namespace fff::ui {

class NumberEdit;
class PropertyGroup;
class PropertyRow;
class SliderField;
class TracePreview;
class Workbench;

class FlatGroup : public QWidget
{
    Q_OBJECT
public:
    /// chosen  the one that it is about; null: none, or a mesh
    FlatGroup(Workbench &bench, std::function<const Template *()> chosen,
              QWidget *parent = nullptr);

    /// Hidden for a mesh.
    void refresh();

Q_SIGNALS:
    void traceWanted(const fff::WantedTrace &wanted);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addPlace();
    void addTrace();
    SliderField *percent(PropertyGroup *group, const QString &name, const char *id, int *kept,
                         const QString &tip);
    void addButtons(PropertyGroup *group,
                    const std::vector<std::tuple<QString, const char *, QString>> &buttons,
                    const std::function<void(const char *)> &act);

    /// As its fields have it.
    PictureTrace trace(const Template &one) const;
    void preview();
    void showPlane();
    QString outlinesFound() const;

    Workbench &m_bench;
    const std::function<const Template *()> m_chosen;
    PropertyGroup *m_place = nullptr, *m_trace = nullptr;
    NumberEdit *m_turn = nullptr;
    SliderField *m_thresholdField = nullptr;
    TracePreview *m_preview = nullptr;
    PropertyRow *m_outlines = nullptr;      // how many are found
    std::vector<QWidget *> m_ofPictures;    // rows
    int m_threshold = 50, m_smoothing = 50; // percent
    const void *m_shown = nullptr;          // whose threshold it is
};

} // namespace fff::ui
