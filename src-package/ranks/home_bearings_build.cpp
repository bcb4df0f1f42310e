// SPDX-License-Identifier: GPL-2.0-or-later
// After a neighbour build, finds the bearings and their home ranks, and sends the pieces of the
// bearings there.
#include "home_bearings.h"

#include "exchange.h"
#include "gather.h"
#include "union_find.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::BearingModel;

namespace bearing {

// Connection that a rank sends to all others, which states that the atom `tag` is in the same piece
// of a bearing as the atom `piece`.
struct Node {
  tag_t piece, tag;
  int owner;     // rank of the owner; -1 if another rank owns the atom
  int ring;      // 1 if `tag` is a ring
  int inside;    // 1 if the piece has atoms of the group
};

struct HomeBearings::Piece {
  enum Kind { body, ring, value, groove, pocket, seat, cell } kind;
  tag_t name;    // name of the bearing
  tag_t a, b;
  // types of the ball and the ring; in other pieces, `first` is the index of a cage, of the fix
  // that moves a ring, or of a value that is given for a single ring
  int first, second;
  int number;    // index of a groove; 1 for a ring on a shaft
  int inside;    // 1 if the atom is in the group
  // `radius` may also be the reach of a pocket; K may also be a value that is given for a single
  // ring, or the position of a ring on its shaft
  double radius, mass, K;
};

void HomeBearings::build(const BearingSources &sources, int groupbit)
{
  sources_ = sources;
  std::vector<NamedBearing> bearings;
  const std::vector<int> bearing_of = find_bearings(groupbit, bearings);
  assemble(bearing::exchange(cut(bearing_of, bearings, groupbit), world));
}

// Returns the bearing number of each owned atom, or -1 for an atom that is not in any bearing with
// atoms of the group. Every rank joins the bodies of the possible contacts of its own balls to
// pieces. The pieces of several ranks are connected by rings and by balls in contact across a
// subdomain boundary.
std::vector<int> HomeBearings::find_bearings(int groupbit, std::vector<NamedBearing> &bearings)
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  const ContactTable &table = *sources_.table;
  UnionFind local(nall);
  for (const RacewayContact &c : table.raceway) local.join(c.i_ball, c.i_ring);
  for (const SphereContact &s : table.sphere) local.join(s.i, s.j);
  for (const CageRails *c : sources_.cages)
    for (const CageRails::CageBall &b : c->balls) local.join(b.i, b.i_ring);
  for (const CagePockets *c : sources_.cage_rings)
    for (const CagePockets::Cell &b : c->cells) local.join(b.i, b.i_cage);

  std::vector<tag_t> piece(nall, 0);    // lowest tag, stored at the root
  std::vector<int> inside(nall, 0);
  for (int i = 0; i < nall; ++i) {
    const int root = local.find(i);
    if (piece[root] == 0 || atom->tag[i] < piece[root]) piece[root] = atom->tag[i];
    if (i < nlocal && (atom->mask[i] & groupbit)) inside[root] = 1;
  }
  std::vector<Node> nodes;
  auto tell = [&](int i) {
    const int root = local.find(i);
    nodes.push_back({piece[root], atom->tag[i], i < nlocal ? comm->me : -1,
                     sources_.is_ring(atom->type[i]), inside[root]});
  };
  for (int i = 0; i < nall; ++i)
    if (sources_.is_ring(atom->type[i])) tell(i);
  for (const BearingSources::MovedRing &m : sources_.moved)    // shafts and supports also connect
                                                               // rings
    for (tag_t other : {m.shaft, m.holder})
      if (other != 0) nodes.push_back({other, atom->tag[m.i], comm->me, 1, 0});
  for (const SphereContact &s : table.sphere)
    if (s.i >= nlocal || s.j >= nlocal) {
      tell(s.i);
      tell(s.j);
    }
  nodes = gather_all(nodes, world);

  UnionFind all;
  std::unordered_map<tag_t, int> number;
  auto of = [&](tag_t tag) {
    const auto found = number.emplace(tag, all.size());
    if (found.second) all.add();
    return found.first->second;
  };
  for (const Node &n : nodes) {
    const int a = of(n.piece), b = of(n.tag);    // both exist before they are joined
    all.join(a, b);
  }
  bearings.assign(all.size(), {0, -1, false});    // stored at the roots
  for (const Node &n : nodes) {
    NamedBearing &b = bearings[all.find(of(n.tag))];
    b.inside = b.inside || n.inside;
    if (n.ring && (b.name == 0 || n.tag <= b.name)) {
      if (n.tag != b.name) b.home = -1;
      b.name = n.tag;
      if (n.owner >= 0) b.home = n.owner;
    }
  }

  std::vector<int> bearing_of(nlocal, -1);
  for (int i = 0; i < nlocal; ++i) {
    const auto found = number.find(piece[local.find(i)]);
    const int b = found == number.end() ? -1 : all.find(found->second);
    if (b >= 0 && bearings[b].name != 0 && bearings[b].inside) bearing_of[i] = b;
    if ((atom->mask[i] & groupbit) && bearing_of[i] < 0)
      BRG_ONE(command_ + ": atom " + std::to_string(atom->tag[i]) +
              " of its group is not a ball, cage ball or ring of a bearing");
  }
  return bearing_of;
}

// Returns the pieces of bearings that this rank owns, indexed by home rank. The lists of atoms
// whose state is sent to a home have the same order as the pieces.
std::vector<std::vector<HomeBearings::Piece>>
HomeBearings::cut(const std::vector<int> &bearing_of, const std::vector<NamedBearing> &bearings,
                  int groupbit)
{
  std::vector<std::vector<Piece>> to(comm->nprocs);
  std::vector<Letter> letter(comm->nprocs);
  auto add = [&](int i, Piece::Kind kind, tag_t a, tag_t b) -> Piece & {
    const NamedBearing &which = bearings[bearing_of[i]];
    Piece p = Piece();
    p.kind = kind;
    p.name = which.name;
    p.a = a;
    p.b = b;
    to[which.home].push_back(p);
    return to[which.home].back();
  };

  std::vector<const BearingSources::MovedRing *> moved(atom->nlocal, nullptr);
  for (const BearingSources::MovedRing &m : sources_.moved) moved[m.i] = &m;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (bearing_of[i] < 0) continue;
    const bool ring = sources_.is_ring(atom->type[i]);
    Piece &p = add(i, ring ? Piece::ring : Piece::body, atom->tag[i], 0);
    p.first = !ring ? atom->type[i] : moved[i] ? moved[i]->mover : -1;
    p.second = atom->type[i];
    p.inside = (atom->mask[i] & groupbit) != 0;
    p.radius = atom->radius[i];
    p.mass = atom->rmass[i];
    Letter &l = letter[bearings[bearing_of[i]].home];
    (ring ? l.ring_atom : l.body_atom).push_back(i);
    if (ring && moved[i] && moved[i]->shaft != 0) {
      p.number = 1;
      p.K = moved[i]->at;
    }
    if (ring && moved[i]) p.b = moved[i]->holder;
    if (ring && moved[i])
      for (const raceway::RingValue &v : moved[i]->own) {
        Piece &own = add(i, Piece::value, atom->tag[i], 0);
        own.first = v.which;
        own.K = v.value;
      }
  }
  for (const RacewayContact &c : sources_.table->raceway) {
    if (bearing_of[c.i_ball] < 0) continue;
    Piece &p = add(c.i_ball, Piece::groove, c.ball, c.ring);
    p.first = atom->type[c.i_ball];
    p.second = atom->type[c.i_ring];
    p.number = c.groove();
    if (sources_.states > 0) letter[bearings[bearing_of[c.i_ball]].home].kept.push_back(c.kept);
  }
  for (const SphereContact &s : sources_.table->sphere) {
    if (s.i >= atom->nlocal || bearing_of[s.i] < 0)
      continue;    // the contact is known on two ranks; it is sent by the owner of the first atom
    Piece &p = add(s.i, Piece::pocket, s.tag_i, s.tag_j);
    p.radius = s.reach;
    p.mass = s.mass;
    p.K = s.K;
  }
  for (size_t k = 0; k < sources_.cages.size(); ++k)
    for (const CageRails::CageBall &b : sources_.cages[k]->balls)
      if (bearing_of[b.i] >= 0) add(b.i, Piece::seat, b.tag, b.ring).first = static_cast<int>(k);

  for (size_t k = 0; k < sources_.cage_rings.size(); ++k)
    for (const CagePockets::Cell &b : sources_.cage_rings[k]->cells)
      if (bearing_of[b.i] >= 0) add(b.i, Piece::cell, b.ball, b.cage).first = static_cast<int>(k);

  own_bodies_.clear();
  own_rings_.clear();
  for (int i : letter[comm->me].body_atom) own_bodies_.push_back({i, Place()});
  for (int i : letter[comm->me].ring_atom) own_rings_.push_back({i, Place()});
  own_contacts_.clear();
  for (double *kept : letter[comm->me].kept) own_contacts_.push_back({kept, Place()});
  away_.clear();
  for (int p = 0; p < comm->nprocs; ++p) {
    if (p == comm->me || (letter[p].body_atom.empty() && letter[p].ring_atom.empty())) continue;
    letter[p].rank = p;
    letter[p].size_text(sources_.states);
    away_.push_back(letter[p]);
  }
  return to;
}

static bool before(const BearingModel::Groove &a, const BearingModel::Groove &b)
{
  if (a.body != b.body) return a.body < b.body;
  return a.ring != b.ring ? a.ring < b.ring : a.physics->number < b.physics->number;
}

// Returns the index in the model of the groove to which a piece belongs.
int HomeBearings::groove_of(const BearingModel &m, int body, int ring, const Piece &p) const
{
  const BearingModel::Groove wanted = {body, ring, sources_.raceway(p.first, p.second, p.number),
                                       nullptr, nullptr};
  return static_cast<int>(std::lower_bound(m.grooves.begin(), m.grooves.end(), wanted, before) -
                          m.grooves.begin());
}

// Finds the rings on a common shaft.
static void find_shafts(BearingModel &m)
{
  for (int k = 0; k < static_cast<int>(m.rings.size()); ++k) {
    const BearingModel::Ring &ring = m.rings[k];
    if (!ring.on_shaft) continue;
    const auto known = std::find_if(m.shafts.begin(), m.shafts.end(),
                                    [&](const auto &s) { return s.mover == ring.mover; });
    if (known == m.shafts.end()) m.shafts.push_back({ring.mover, {k}});
    else known->rings.push_back(k);
  }
}

// Finds the rings that support other rings.
static void find_holders(BearingModel &m)
{
  for (BearingModel::Ring &ring : m.rings)
    for (int k = 0; ring.held_by != 0 && k < static_cast<int>(m.rings.size()); ++k)
      if (m.rings[k].tag == ring.held_by) ring.holder = k;
}

// Returns the ring whose land guides a cage, or -1 if there is none.
static int land_of(const BearingModel &m, const BearingModel::Cage &cage)
{
  if (cage.of->guide == raceway::CageRing::by_balls) return -1;
  const raceway::Side side =
      cage.of->guide == raceway::CageRing::by_inner ? raceway::Side::inner : raceway::Side::outer;
  for (const BearingModel::Groove &g : m.grooves)
    if (g.body == cage.balls.front() && g.physics->groove.side == side) return g.ring;
  return -1;
}

// Builds the models on the home rank, in the order of the names of the bearings and with the atoms
// in the order of tags.
void HomeBearings::assemble(const std::vector<std::vector<Piece>> &from)
{
  std::vector<Piece> pieces;
  for (const std::vector<Piece> &f : from) pieces.insert(pieces.end(), f.begin(), f.end());
  std::vector<tag_t> names;
  for (const Piece &p : pieces) names.push_back(p.name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::unordered_map<tag_t, int> number_of;
  for (size_t k = 0; k < names.size(); ++k) number_of[names[k]] = static_cast<int>(k);

  bearings_.assign(names.size(), HomeBearing());
  const Piece *outsider = nullptr;
  for (const Piece &p : pieces) {
    BearingModel &m = bearings_[number_of[p.name]].model;
    if (p.kind == Piece::body)
      m.bodies.push_back({p.a, p.mass, p.radius, sources_.is_ball(p.second)});
    else if (p.kind == Piece::ring) m.rings.push_back({p.a, p.first, {}, p.number == 1, p.K, p.b});
    else continue;
    if (!p.inside && (!outsider || p.a < outsider->a)) outsider = &p;
  }
  if (outsider)
    BRG_ONE(command_ + ": atom " + std::to_string(outsider->a) + " (type " +
            std::to_string(outsider->second) +
            ") belongs to a bearing that has other atoms in the fix's group; put balls, cage balls "
            "and rings in the group");

  std::vector<std::unordered_map<tag_t, int>> at(bearings_.size());    // of bodies and rings
  for (size_t k = 0; k < bearings_.size(); ++k) {
    BearingModel &m = bearings_[k].model;
    std::sort(m.bodies.begin(), m.bodies.end(),
              [](const BearingModel::Body &a, const BearingModel::Body &b) {
                return a.spins != b.spins ? a.spins : a.tag < b.tag;
              });
    std::sort(
        m.rings.begin(), m.rings.end(),
        [](const BearingModel::Ring &a, const BearingModel::Ring &b) { return a.tag < b.tag; });
    find_shafts(m);
    find_holders(m);
    if (m.bodies.empty())
      BRG_ONE(command_ + ": atom " + std::to_string(m.name()) +
              " of its group is not a ball, cage ball or ring of a "
              "bearing; a cage ring needs a fix bearing/cage/ring");
    for (size_t b = 0; b < m.bodies.size(); ++b) at[k][m.bodies[b].tag] = static_cast<int>(b);
    for (size_t r = 0; r < m.rings.size(); ++r) at[k][m.rings[r].tag] = static_cast<int>(r);
    bearings_[k].bodies.resize(m.bodies.size());
    bearings_[k].rings.resize(m.rings.size());
    bearings_[k].steps.resize(m.rings.size());
  }
  finish(pieces, number_of, at);

  guests_.clear();
  size_t own_body = 0, own_ring = 0, own_contact = 0;
  for (int rank = 0; rank < comm->nprocs; ++rank) {
    Letter l;
    l.rank = rank;
    for (const Piece &p : from[rank]) {
      const int number = number_of[p.name];
      if (p.kind == Piece::groove && sources_.states > 0) {
        const Place place = {
            number, groove_of(bearings_[number].model, at[number][p.a], at[number][p.b], p)};
        if (rank != comm->me) l.contact_place.push_back(place);
        else own_contacts_[own_contact++].place = place;
      }
      if (p.kind != Piece::body && p.kind != Piece::ring) continue;
      const Place place = {number, at[number][p.a]};
      if (rank != comm->me) (p.kind == Piece::body ? l.body_place : l.ring_place).push_back(place);
      else if (p.kind == Piece::body) own_bodies_[own_body++].place = place;
      else own_rings_[own_ring++].place = place;
    }
    if (l.body_place.empty() && l.ring_place.empty()) continue;
    l.size_text(sources_.states);
    guests_.push_back(l);
  }
}

// Sets the contacts of the models.
void HomeBearings::finish(const std::vector<Piece> &pieces,
                          const std::unordered_map<tag_t, int> &number_of,
                          const std::vector<std::unordered_map<tag_t, int>> &at)
{
  struct CageSeat {
    int cage;
    BearingModel::Seat seat;
  };
  std::vector<std::vector<CageSeat>> seats(bearings_.size());
  for (const Piece &p : pieces) {
    if (p.kind == Piece::body || p.kind == Piece::ring) continue;
    const int k = number_of.at(p.name);
    BearingModel &m = bearings_[k].model;
    if (p.kind == Piece::value) {
      m.rings[at[k].at(p.a)].own.push_back({p.first, p.K});
      continue;
    }
    const int a = at[k].at(p.a), b = at[k].at(p.b);
    if (p.kind == Piece::groove) {
      const raceway::RacewayPhysics *physics = sources_.raceway(p.first, p.second, p.number);
      m.grooves.push_back({a, b, physics,
                           sources_.profile ? sources_.profile(p.b, physics) : nullptr,
                           sources_.ball_profile ? sources_.ball_profile(p.a, physics) : nullptr});
    }
    if (p.kind == Piece::pocket) m.pockets.push_back({a, b, p.K, p.radius, p.mass});
    if (p.kind == Piece::seat) {
      const CageRails &c = *sources_.cages[p.first];
      seats[k].push_back({p.first, {a, b, &c.rails, &c.stiffness}});
    }
    if (p.kind == Piece::cell) {
      const raceway::CageRing *of = &sources_.cage_rings[p.first]->of;
      const auto known = std::find_if(m.cages.begin(), m.cages.end(),
                                      [b](const BearingModel::Cage &c) { return c.ring == b; });
      if (known == m.cages.end()) m.cages.push_back({b, -1, of, {a}});
      else known->balls.push_back(a);
    }
  }
  for (size_t k = 0; k < bearings_.size(); ++k) {
    BearingModel &m = bearings_[k].model;
    std::sort(m.grooves.begin(), m.grooves.end(), before);
    bearings_[k].states.assign(m.grooves.size() * sources_.states, 0.0);
    auto tag = [&m](int body) { return m.bodies[body].tag; };
    std::sort(m.pockets.begin(), m.pockets.end(),
              [&](const BearingModel::Pocket &a, const BearingModel::Pocket &b) {
                return a.a != b.a ? tag(a.a) < tag(b.a) : tag(a.b) < tag(b.b);
              });
    std::sort(seats[k].begin(), seats[k].end(), [](const CageSeat &a, const CageSeat &b) {
      return a.cage != b.cage ? a.cage < b.cage : a.seat.body < b.seat.body;
    });
    for (const CageSeat &s : seats[k]) m.seats.push_back(s.seat);
    std::sort(
        m.cages.begin(), m.cages.end(),
        [](const BearingModel::Cage &x, const BearingModel::Cage &y) { return x.ring < y.ring; });
    for (BearingModel::Cage &c : m.cages) {
      std::sort(c.balls.begin(), c.balls.end());
      c.land = land_of(m, c);
    }
  }
}

}    // namespace bearing
