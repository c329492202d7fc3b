// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"
#include "solver/base/tasks.hpp"

namespace corpuscle::contact {

/// Which contacts may be worked on at the same time, although each changes values of its nodes.
///
/// Space is cut into square columns, along the axis in which the cloth is thinnest. A contact is of
/// the column that the mean of its nodes is in, if all of them lie within half a column's width of
/// it. So two columns with another between them have no node in common, and there are four colours
/// of columns, each of which waits only for those of the eight around it that have a colour before
/// its own; of a colour the fullest first. What reaches farther is of a column twice as wide, after
/// all narrow ones near it. What reaches farther still (large facets), and what touches a rigid body
/// that may move, is worked on alone, after all others. The order in which contacts with a node in
/// common are worked on does not depend on the number of threads.
class ColumnColouring {
public:
    static constexpr std::size_t COUNT =
        Contact::ALONE;  ///< names of columns; those that are far apart share

    explicit ColumnColouring(const Cloth& cloth) : cloth_(cloth) {}

    /// Of a column: 0-3; of a wide one 4-7.
    [[nodiscard]] static unsigned colour(unsigned column) {
        return column < WIDE.first ? column / NARROW.of_one()
                                   : Width::colours() + (column - WIDE.first) / WIDE.of_one();
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
        const auto over_task = [&](std::size_t task) { body(std::size_t{task_[task]}); };
        const auto before = [&](std::size_t task, auto&& visit) {
            for_each_near(task_[task], [&](std::size_t column) {
                if (task_of_[column] < task) visit(std::size_t{task_of_[column]});
            });
        };
        tasks_.run(shares_, before, over_task, is_worth_threads(), where);
        body(COUNT);
    }
    /// Likewise, of bodies that change nothing of the nodes: no column waits for another.
    template <class Body>
    void for_each_column_apart(Body&& body,
                               parallel::Cut::Where where = parallel::Cut::Where::current()) const {
        tasks_.run(
            shares_, [](std::size_t, auto&&) {},
            [&](std::size_t task) { body(std::size_t{task_[task]}); }, is_worth_threads(), where);
        body(COUNT);
    }
    /// Likewise of one thread, for what those bodies have found.
    template <class Body>
    void for_each_in_turn(Body&& body) const {
        for (std::size_t task = 0; task < filled_; ++task) body(std::size_t{task_[task]});
        body(COUNT);
    }

private:
    static constexpr std::uint16_t NONE = COUNT;
    [[nodiscard]] bool is_worth_threads() const {
        constexpr std::size_t FEW = 64;  // contacts that one thread is done with sooner
        return order_.size() > FEW;
    }

    void sort_by_size();
    void sort_by_size(std::size_t first, std::size_t count);
    void deal_out();
    /// Columns of one width, whose names follow each other, those of one colour first.
    struct Width {
        unsigned across;  ///< names along each axis, then used again
        unsigned first;   ///< name

        [[nodiscard]] static constexpr unsigned colours() { return APART * APART; }
        [[nodiscard]] constexpr unsigned of_one() const { return across * across / colours(); }
        [[nodiscard]] std::uint16_t name(unsigned i, unsigned j) const {
            i %= across;
            j %= across;
            const unsigned colour = i % APART + APART * (j % APART);
            return static_cast<std::uint16_t>(first + of_one() * colour +
                                              across / APART * (i / APART) + j / APART);
        }
        [[nodiscard]] std::array<unsigned, 2> place(unsigned column) const {
            const unsigned colour = (column - first) / of_one();
            const unsigned within = (column - first) % of_one(), row = across / APART;
            return {APART * (within / row) + colour % APART,
                    APART * (within % row) + colour / APART};
        }
    };
    static constexpr unsigned APART = 2;    ///< from a column to the next of its colour
    static constexpr unsigned ACROSS = 16;  ///< narrow ones
    static constexpr Width NARROW{ACROSS, 0}, WIDE{ACROSS / 2, ACROSS*ACROSS};

    /// visit(column) for those near one that may have a node in common with it: the eight around it;
    /// and the narrow ones that lie within a wide one or reach into what it reaches.
    template <class Visit>
    static void for_each_near(std::size_t column, Visit&& visit) {
        const bool is_wide = column >= WIDE.first;
        const Width& own = is_wide ? WIDE : NARROW;
        const auto [i, j] = own.place(static_cast<unsigned>(column));
        for (unsigned k = 0; k < 9; ++k)
            if (k != 4)
                visit(
                    std::size_t{own.name(i + k / 3 + own.across - 1, j + k % 3 + own.across - 1)});
        if (!is_wide) return;
        constexpr unsigned REACH = 2, ALL = 2 + 2 * REACH;
        for (unsigned k = 0; k < ALL * ALL; ++k)
            visit(std::size_t{
                NARROW.name(2 * i + k / ALL + ACROSS - REACH, 2 * j + k % ALL + ACROSS - REACH)});
    }

    struct Slot {
        std::uint32_t chunk, row;
    };

    const Cloth& cloth_;
    std::array<int, 2> axis_{0, 1};      ///< across the columns
    std::array<double, 2> per_width_{};  ///< 1 / the narrow ones' width along each        [1/m]
    std::vector<Slot> order_;
    std::array<std::size_t, COUNT + 2> start_{};  ///< by column, and of those that stand alone
    std::array<std::uint16_t, COUNT> task_{};     ///< columns with contacts
    std::array<std::uint16_t, COUNT> task_of_{};  ///< by column; NONE: it has no contacts
    std::size_t filled_ = 0;                      ///< columns with contacts
    parallel::TaskShares shares_;
    mutable parallel::Tasks tasks_;
    std::vector<std::array<std::uint32_t, COUNT + 1>> next_;  ///< by some chunks and column
};

}  // namespace corpuscle::contact
