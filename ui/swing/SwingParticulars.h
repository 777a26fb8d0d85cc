#pragma once

#include <QWidget>

#include "core/record/Fleet.h"
#include "ui/kit/FormField.h"

namespace lubberline::ui {

class SwingEditor;

/// Date, site, kind, configuration, datum, people, variation: everything of a swing besides its readings, stored field by field
/// as it is left.
class SwingParticulars : public QWidget {
    Q_OBJECT

public:
    explicit SwingParticulars(SwingEditor& editor, QWidget* parent = nullptr);

private:
    void buildOccasion(QFormLayout& form);
    void buildConfiguration(QFormLayout& form);
    void buildPeople(QFormLayout& form);
    void showRecord();
    void reloadSites();

    SwingEditor& m_editor;
    FormFields<Swing> m_fields;
    QComboBox* m_site = nullptr;
    std::vector<Site> m_sites;
};

} // namespace lubberline::ui
