// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"

namespace corpuscle::contact {

/// Which contacts may be worked on at the same time, although each changes values of its nodes.
///
/// Space is cut into square columns, along the axis in which the cloth is thinnest. A contact is of
/// the column that the mean of its nodes is in, if all of them lie within half a column's width of
/// it. So two columns with another between them have no node in common, and there are four colours
/// of columns each of which all threads work on at once, the fullest first. What reaches farther
/// (large facets), and what touches a rigid body that may move, is worked on alone, after all
/// others. The order does not depend on the number of threads.
class ColumnColouring {
public:
    static constexpr std::size_t COUNT =
        Contact::ALONE;  ///< names of columns; those that are far apart share

    explicit ColumnColouring(const Cloth& cloth) : cloth_(cloth) {
        std::iota(by_size_.begin(), by_size_.end(), std::uint16_t{0});
    }

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
    void for_each(List& contacts, Body&& body,
                  parallel::Cut::Where where = parallel::Cut::Where::current()) const {
        if (order_.empty()) return;
        const auto over_column = [&](std::size_t column) {
            for (std::size_t i = start_[column]; i < start_[column + 1]; ++i)
                body(contacts.chunk(order_[i].chunk)[order_[i].row]);
        };
        for_each_column(over_column, where);
    }
    /// Likewise body(column), the columns' contacts being up to the body.
    template <class Body>
    void for_each_column(Body&& body,
                         parallel::Cut::Where where = parallel::Cut::Where::current()) const {
        const parallel::Cut cut(is_worth_threads() ? 1 : PER_COLOUR, where);
        const auto of_colour = [&](std::size_t colour) {
            const std::span<const std::uint16_t> columns = filled(colour);
            return parallel::each(
                columns.size(), [&body, columns](std::size_t i) { body(std::size_t{columns[i]}); },
                cut);
        };
        parallel::in_turn(COLOURS, of_colour);
        body(COUNT);
    }
    /// Likewise of one thread, for what those bodies have found.
    template <class Body>
    void for_each_in_turn(Body&& body) const {
        for (std::size_t colour = 0; colour < COLOURS; ++colour)
            for (const std::uint16_t column : filled(colour)) body(std::size_t{column});
        body(COUNT);
    }

private:
    static constexpr std::size_t COLOURS = 4, PER_COLOUR = COUNT / COLOURS;
    [[nodiscard]] bool is_worth_threads() const {
        constexpr std::size_t FEW = 256;  // contacts that one thread is done with sooner
        return order_.size() > FEW;
    }

    void sort_by_size();
    /// Columns of a colour that have contacts, the largest first.
    [[nodiscard]] std::span<const std::uint16_t> filled(std::size_t colour) const {
        return std::span(by_size_).subspan(colour * PER_COLOUR, filled_[colour]);
    }

    struct Slot {
        std::uint32_t chunk, row;
    };

    const Cloth& cloth_;
    std::array<int, 2> axis_{0, 1};  ///< across the columns
    double per_width_ = 0.0;         ///< 1 / their width                                  [1/m]
    std::vector<Slot> order_;
    std::array<std::size_t, COUNT + 2> start_{};  ///< by column, and of those that stand alone
    std::array<std::uint16_t, COUNT> by_size_;    ///< each colour's columns, the largest first
    std::array<std::size_t, COLOURS> filled_{};   ///< of those have contacts
    std::vector<std::array<std::uint32_t, COUNT + 1>> next_;  ///< by some chunks and column
};

}  // namespace corpuscle::contact
