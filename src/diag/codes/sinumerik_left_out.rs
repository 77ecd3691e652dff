//! `S8`: calls, actions, couplings and measurings of SINUMERIK programs that the output leaves out.

super::codes! { SINUMERIK_LEFT_OUT:

S8163 Warning "siemens-change-left-out" "tool is chosen and never changed in"
"T chose a tool, a call that `[programs]` leaves out follows, and no M6 changes the tool in. If the program after that call is the tool change of the machine, the \
output cuts with the tool before it. Say what the call does: `TC = { change = true }` changes to the tool that T chose, `TC = { tool = 1 }` to the tool of its first argument. Where T \
itself changes the tool (a turret), set `[control] tool_change = \"t\"`. A tool that an M6 changes in later is only chosen ahead, and nothing is reported; where T chooses it once more after \
something was cut, that may have been the cut of this tool, and it is. The same holds for a call that names a tool in quotation marks: one of `[tools]` or `$TC_TP2`, or any name before the first tool." {
    t_chose_tool_before_call(number, name)
        "T chose tool {number} before {name}, which is left out, and no M6 changes it in before the next cut: the tool \
        before it goes on cutting"
        asks "if {name} changes the tool, say so: `{name} = {{ change = true }}` under `[programs]`; if T itself does, set \
        `[control] tool_change = \"t\"`";
    call_names_tool(name, number, tool, place)
        "{name}, which is left out, names tool {number}, \"{tool}\", and no M6 changes it in before the next cut: the tool \
        before it goes on cutting"
        asks "if {name} changes the tool, say so: `{name} = {{ tool = {place} }}` under `[programs]`";
    call_may_name_tool(name, tool, place)
        "{name}, which is left out, may name a tool, \"{tool}\", and the program has changed none: it cuts with whatever \
        is in the spindle"
        asks "if {name} changes the tool, say so: `{name} = {{ tool = {place} }}` under `[programs]`";
}

S8171 Warning "siemens-feed-of-before-call" "cut takes the feed of before a call that is left out"
"Between the last F and this cut stands a call that `[programs]` leaves out or takes for a tool change. If its program leaves another feed on the control, \
the output cuts at the wrong one. Program F after the call, or say what it leaves: `TC = { ignore = true, feed = 0.2 }`, in the unit that F \
has there; `feed = \"lost\"` makes every cut without an F of its own an error. It is said once for each program that is called." {
    this_cut_takes_feed_of_before(name)
        "this cut takes the feed of before {name}, which is left out and may leave another one";
}

S8165 Warning "siemens-action-left-out" "synchronized action is left out"
"`[control] synchronized_actions = \"leave-out\"` leaves out actions that set outputs, markers, the feed or a wait only. The path is the same; when outputs come and how fast the \
axes move is not. Actions that move an axis, act on the spindle or set a value that the program reads are refused all the same." {
    synchronized_action_is_left_out(action) "the synchronized action `{action}` is left out"
        help "check that the target needs nothing of it";
    synchronized_action_is_left_out_with(action, functions)
        "the synchronized action `{action}` is left out, and with it {functions}"
        help "check that the target needs nothing of it";
    synchronized_action_of_pace_is_left_out(action)
        "the synchronized action `{action}` is left out; feed and waits are not those of the control"
        help "check that the target needs nothing of it";
    synchronized_action_of_pace_is_left_out_with(action, functions)
        "the synchronized action `{action}` is left out, and with it {functions}; feed and waits are not those of the \
        control"
        help "check that the target needs nothing of it";
}

S8166 Warning "siemens-coupling-left-out" "coupling or oscillation is left out"
"`[control] couplings` and `oscillation` leave out words whose axis is left out by `[machine] axes`, and what ends a coupling that the output does not have. \
Where an axis of the output follows or swings they are refused all the same." {
    is_left_out(name, what) "{name} is left out: it {what}";
}

S8167 Warning "siemens-measuring-left-out" "measuring is left out"
"`[control] probing = \"leave-out\"` leaves out measuring cycles, and blocks with MEAS together with their moves. Where the \
probe left the axes is known at the machine only: increments and arcs after it are refused until the program says where the tool is. \
MEAW and MEAWA go their whole way, so their moves are printed; so do all where `[control] probing_contact = \"none\"` says that the \
probe touches nothing. What is measured is asked for by its name where the program reads it." {
    is_left_out_what_it_measures(name, what)
        "{name} is left out: what it measures is known at the machine only{what}";
    its_block_moves_no_axis(name) "{name} is left out: its block moves no axis of the output"
        help "check what follows: no move of the target stands for this one";
    is_left_out_with_its_move(name, letters, stops)
        "{name} is left out with its move: where {letters} {stops} is known at the machine only"
        help "check what follows: no move of the target stands for this one";
    probe_touches_nothing(name)
        "{name} is left out, its move is not: the probe touches nothing, as `[control] probing_contact` says"
        help "the block goes its whole way, whatever the probe does: check that nothing stands in it";
    its_move_is_not_left_out(name)
        "{name} is left out, its move is not: what it measures is known at the machine only"
        help "the block goes its whole way, whatever the probe does: check that nothing stands in it";
}

S8168 Note "siemens-measuring-arguments" "arguments of measuring cycles are left out"
"`_MVAR`, `_SETVAL`, `_KNUM` and others tell a measuring cycle what to do. They have no effect on anything else, and are left out with the cycle." {
    arguments_of_measuring_cycles()
        "the arguments of the measuring cycles, which the control keeps in its global data, are left out";
}

S8169 Warning "siemens-measured-value-given" "value of the configuration stands for a measured one"
"The program computes with what a probe found, and `[variables]` gives a number for it. One number stands for all measurings of the program: check that it is right for the one that the message names. \
`[control] probing_contact = \"none\"` does the same for `$AC_MEA`, which it makes 0." {
    of_variables_is_taken_for_what(key, value, name, line)
        "`{key}` = {value} of `[variables]` is taken for what {name} in line {line} finds";
    is_0_in_line_touches_nothing(key, name, line)
        "`{key}` is 0: {name} in line {line} touches nothing, as `[control] probing_contact` says";
}

S8170 Note "siemens-action-words" "words that act on synchronized actions are left out"
"CANCEL, LOCK, UNLOCK and RESET end, hold, free and reset synchronized actions, none of which is in the output." {
    acts_on_synchronized_actions(name) "{name} acts on synchronized actions, and is left out like them";
}
}
