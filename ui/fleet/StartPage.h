#pragma once

#include <QWidget>

namespace lubberline::ui {

/// What an empty database opens on: three large choices.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

signals:
    void demonstrationWanted();
    void importWanted();
    void newSwingWanted();
};

} // namespace lubberline::ui
