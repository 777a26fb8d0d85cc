#pragma once

#include "ui/kit/Page.h"

namespace lubberline::ui {

/// What an empty database opens on: three large choices.
class StartPage : public Page {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    static PageDescription description(PageContext& context);
    [[nodiscard]] bool isOf(const FleetItem&) const override { return true; }
    void fleetChanged() override { emit filled(); }

signals:
    void demonstrationWanted();
    void importWanted();
    void newSwingWanted();
    void filled(); ///< the database may be empty no longer
};

} // namespace lubberline::ui
