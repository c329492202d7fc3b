// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/energy/ledger.hpp"

namespace corpuscle {

EnergyBooks Ledger::balance(const EnergyBooks& instant) const {
    const auto mean = [&](double Moved::*entry) {
        return (1.0 - weight) * before.*entry + weight * after.*entry;
    };
    EnergyBooks books = instant;
    books.kinetic = mean(&Moved::kinetic);
    books.contact = mean(&Moved::contact);
    books.friction += mean(&Moved::friction);
    books.damping += mean(&Moved::damping);
    books.ambient = mean(&Moved::ambient);
    books.external = mean(&Moved::external);
    books.smoothing = instant.smoothing - mean(&Moved::smoothing);
    books.total = books.kinetic + books.strain + books.gas + books.smoothing + books.contact +
                  books.friction + books.damping + books.ambient + books.outflow;
    books.residual = books.total - (start_ + books.inflow + books.external);
    return books;
}

}  // namespace corpuscle
