// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"

namespace corpuscle::contact {

/// Which contacts may be worked on at the same time, although each changes values of its nodes.
///
/// Space is cut into square columns, along the axis in which the cloth is thinnest. A contact is of
/// the column that the mean of its nodes is in, if all of them lie within half a column's width of
/// it. So two columns with another between them have no node in common, and there are four colours
/// of columns each of which all threads work on at once. What reaches farther (large facets), and
/// what touches a rigid body, is worked on alone, after all others. The order does not depend on
/// the number of threads.
class ColumnColouring {
public:
    static constexpr std::size_t COUNT = 256;  ///< names of columns; those that are far apart share

    explicit ColumnColouring(const Cloth& cloth) : cloth_(cloth) {}

    /// Lays the columns for cloth at x.
    void lay(const Points& x);

    /// Name of the column that a contact is of, or Contact::ALONE.
    [[nodiscard]] std::uint16_t of(const Contact& contact, const Points& x) const;

    /// Sorts contacts by their columns, those of one in the order of the list.
    void sort(const ContactList& contacts);

    /// Contacts of a column.
    [[nodiscard]] std::size_t size(std::size_t column) const {
        return start_[column + 1] - start_[column];
    }
    [[nodiscard]] std::size_t size() const { return order_.size(); }

    /// Those of a column are in rows begin(column) ... begin(column + 1) - 1 of all.
    [[nodiscard]] std::size_t begin(std::size_t column) const { return start_[column]; }
    template <class List>
    [[nodiscard]] auto& at(std::size_t row, List& contacts) const {
        return contacts.chunk(order_[row].chunk)[order_[row].row];
    }

    /// body(contact), one after the other wherever two have a node in common, always in the same
    /// order. List: ContactList, const or not, as it was sorted.
    template <class List, class Body>
    void for_each(List& contacts, Body&& body) const {
        if (order_.empty()) return;
        for_each([&](std::size_t column) {
            for (std::size_t i = start_[column]; i < start_[column + 1]; ++i)
                body(contacts.chunk(order_[i].chunk)[order_[i].row]);
        });
    }
    /// Likewise body(column), the columns' contacts being up to the body.
    template <class Body>
    void for_each(Body&& body) const {
        for (std::size_t colour = 0; colour < COLOURS; ++colour)
            parallel::for_each(
                PER_COLOUR, [&](std::size_t i) { body(colour * PER_COLOUR + i); },
                is_worth_threads() ? 1 : PER_COLOUR);
        body(COUNT);
    }

private:
    static constexpr std::size_t COLOURS = 4, PER_COLOUR = COUNT / COLOURS;
    [[nodiscard]] bool is_worth_threads() const {
        constexpr std::size_t FEW = 256;  // contacts that one thread is done with sooner
        return order_.size() > FEW;
    }

    struct Slot {
        std::uint32_t chunk, row;
    };

    const Cloth& cloth_;
    std::array<int, 2> axis_{0, 1};  ///< across the columns
    double per_width_ = 0.0;         ///< 1 / their width                                  [1/m]
    std::vector<Slot> order_;
    std::array<std::size_t, COUNT + 2> start_{};  ///< by column, and of those that stand alone
    std::vector<std::array<std::uint32_t, COUNT + 1>> next_;  ///< by chunk and column
};

}  // namespace corpuscle::contact
