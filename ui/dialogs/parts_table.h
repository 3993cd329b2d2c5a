// All parts of a model: number, name, size, area and how many there are of each.
#pragma once

#include "core/fabrication/part_list.h"

#include <QTreeWidget>

namespace fff::ui {

class PartsTable : public QTreeWidget
{
public:
    explicit PartsTable(QWidget *parent = nullptr);

    void setParts(const std::vector<ListedPart> &parts);
};

} // namespace fff::ui
