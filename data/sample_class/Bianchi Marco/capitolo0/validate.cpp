#include "exercises/00_table/validate.h"

#include <map>

namespace {

// Asks all questions; one member function per column of the table.
class Checker
{
public:
	explicit Checker(const HalfEdgeTable& table) : he(table)
	{
		for (int i = 0; i < he.size(); ++i) ++users[he[i].next];
	}

	std::vector<Finding> all()
	{
		for (row = 0; row < he.size(); ++row) {
			vertex();
			face();
			opposite();
			successor();
		}
		return findings;
	}

private:
	bool exists(int i) const { return i >= 0 && i < he.size(); }
	void report(Fault f) { findings.push_back({f, row}); }

	void vertex()
	{
		if (he[row].vi < 0) report(Fault::vertex_out_of_range);
	}
	void face()
	{
		if (he[row].fi < -1) report(Fault::face_out_of_range);
	}
	void opposite()
	{
		int o = he[row].opp;
		if (!exists(o)) {
			report(Fault::opp_out_of_range);
			return;
		}
		if (o == row) report(Fault::opp_is_itself);
		if (he[o].opp != row) report(Fault::opp_not_mutual);
		if (he[o].vi == he[row].vi) report(Fault::opp_same_start);
	}
	void successor()
	{
		int n = he[row].next;
		int o = he[row].opp;
		if (!exists(n)) {
			report(Fault::next_out_of_range);
			return;
		}
		if (exists(o) && he[n].vi != he[o].vi) report(Fault::next_not_at_tip);
		if (he[n].fi != he[row].fi) report(Fault::next_changes_face);
		if (users[n] > 1) report(Fault::next_shared);
	}

	const HalfEdgeTable& he;
	std::map<int, int> users;
	std::vector<Finding> findings;
	int row = 0;
};

}

std::vector<Finding> validate(const HalfEdgeTable& he)
{
	return Checker(he).all();
}
