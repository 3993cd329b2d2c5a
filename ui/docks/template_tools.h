// The tools that hold the chosen template in the view: its handles, and the line that says how
// large it is.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/base/ids.h"

#include <functional>
#include <string_view>
#include <vector>

class QPushButton;

namespace fff {
struct Template;
}

namespace fff::ui {

class Workbench;

class TemplateTools : public QWidget
{
    Q_OBJECT
public:
    /// chosen  the one that they are for; null: none
    TemplateTools(Workbench &bench, std::function<const Template *()> chosen,
                  QWidget *parent = nullptr);

    /// The chosen one has its handles, unless it cannot be moved.
    void hold();
    /// Another one is chosen: a tool in the hand goes on with that.
    void follow();
    /// One step back of what they hold; false: they hold nothing.
    bool escape();
    void refresh();

Q_SIGNALS:
    /// Its keys are the view's from now on.
    void viewWanted();

private:
    QPushButton *addTool(const QString &text, const char *name, const QString &tip,
                         std::string_view command);
    /// The template that is held by that tool; not valid: none is.
    TemplateId held(std::string_view command) const;
    void run(std::string_view command);

    Workbench &m_bench;
    const std::function<const Template *()> m_chosen;
    struct Button
    {
        std::string_view command;
        QPushButton *button;
    };
    std::vector<Button> m_buttons;
};

} // namespace fff::ui
