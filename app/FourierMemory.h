#pragma once

namespace lubberline::app {

/// FFTW's plans are looked for once a machine: what it found is read from the user's cache folder while this lives, and kept
/// there at its end. Where the folder cannot be used nothing is lost but time.
class FourierMemory {
public:
    FourierMemory();
    ~FourierMemory();
    FourierMemory(const FourierMemory&) = delete;
    FourierMemory& operator=(const FourierMemory&) = delete;
};

} // namespace lubberline::app
