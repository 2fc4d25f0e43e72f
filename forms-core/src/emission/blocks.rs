//! Blocks: values that only one branch of a conditional needs are computed in that branch.
//!
//! The block of a value is the innermost one that contains every use of the value. Conditionals
//! form a tree of blocks below the block of the function.

use crate::kernel::{Instruction, Program, Value};

/// Block, by its number; the block of the function is the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Block(usize);

/// Block of the function.
pub(super) const FUNCTION: Block = Block(0);

/// Assignment of instructions to the blocks in which they are written.
pub(super) struct Blocks {
    /// Block of each instruction.
    of: Vec<Block>,
    /// Parent of each block, and its depth.
    parents: Vec<(Block, usize)>,
    /// Value that each block ends in, if it ends in a single one.
    values: Vec<Option<Value>>,
    /// Computed instructions of each block.
    members: Vec<Vec<usize>>,
    /// Blocks of each conditional: for a relation that holds, and for one that fails.
    branches: Vec<Option<[Block; 2]>>,
}

impl Blocks {
    /// Puts everything into the block of the function, for targets whose conditionals compute both
    /// branches.
    pub(super) fn one(program: &Program) -> Blocks {
        let mut blocks = Blocks::function(program);
        blocks.list_members(program);
        blocks
    }

    fn function(program: &Program) -> Blocks {
        let length = program.instructions.len();
        let value = if let [value] = program.outputs[..] { Some(value) } else { None };
        Blocks {
            of: vec![FUNCTION; length],
            parents: vec![(FUNCTION, 0)],
            values: vec![value],
            members: Vec::new(),
            branches: vec![None; length],
        }
    }

    fn list_members(&mut self, program: &Program) {
        self.members = vec![Vec::new(); self.parents.len()];
        for (place, instruction) in program.instructions.iter().enumerate() {
            if !matches!(instruction, Instruction::Constant(_) | Instruction::Argument(_)) {
                self.members[self.of[place].0].push(place);
            }
        }
    }

    /// Nests every instruction as deep as its uses allow.
    pub(super) fn nested(program: &Program) -> Blocks {
        let mut blocks = Blocks::function(program);
        let mut found: Vec<Option<Block>> = vec![None; program.instructions.len()];
        for root in program.roots() {
            found[root.place()] = Some(FUNCTION);
        }
        for place in (0..program.instructions.len()).rev() {
            let block = found[place].unwrap_or(FUNCTION);
            blocks.of[place] = block;
            let mut used_in = |value: Value, by: Block, blocks: &Blocks| {
                let known = &mut found[value.place()];
                *known = Some(known.map_or(by, |known| blocks.common(known, by)));
            };
            if let Instruction::Select { left, right, then, otherwise, .. } = &program.instructions[place] {
                let branches = [blocks.within(block, *then), blocks.within(block, *otherwise)];
                blocks.branches[place] = Some(branches);
                let uses = [(left, block), (right, block), (then, branches[0]), (otherwise, branches[1])];
                uses.into_iter().for_each(|(value, by)| used_in(*value, by, &blocks));
            } else {
                let operands = program.instructions[place].operands();
                operands.into_iter().for_each(|operand| used_in(operand, block, &blocks));
            }
        }
        blocks.list_members(program);
        blocks
    }

    /// Creates a block within this one that ends in a value.
    fn within(&mut self, block: Block, value: Value) -> Block {
        self.values.push(Some(value));
        self.parents.push((block, self.parents[block.0].1 + 1));
        Block(self.parents.len() - 1)
    }

    /// Returns the innermost block that contains both.
    fn common(&self, mut a: Block, mut b: Block) -> Block {
        while a != b {
            let outwards = if self.parents[a.0].1 >= self.parents[b.0].1 { &mut a } else { &mut b };
            *outwards = self.parents[outwards.0].0;
        }
        a
    }

    /// Returns the computed instructions of a block, in their order.
    pub(super) fn members(&self, block: Block) -> Vec<usize> {
        self.members[block.0].clone()
    }

    /// Returns the value that a block ends in, if it ends in a single one.
    pub(super) fn value(&self, block: Block) -> Option<Value> {
        self.values[block.0]
    }

    /// Returns the blocks of a conditional.
    pub(super) fn branches(&self, place: usize) -> Option<[Block; 2]> {
        self.branches[place]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::formula::program;
    use crate::kernel::numbering::number_values;

    /// Returns the nesting depths of the sines of a kernel, in the order of their computation.
    fn depths(formula: &str) -> Vec<usize> {
        let program = number_values(&program("x y", &[formula]));
        let blocks = Blocks::nested(&program);
        let is_call = |place: &usize| matches!(program.instructions[*place], Instruction::Call(..));
        let calls = (0..program.instructions.len()).filter(is_call);
        calls.map(|place| blocks.parents[blocks.of[place].0].1).collect()
    }

    #[test]
    fn what_one_branch_needs_stands_in_it_and_what_both_need_before_them() {
        assert_eq!(depths("if x < y { sin(x) } else { sin(y) }"), [1, 1]);
        assert_eq!(depths("if x < y { sin(x) } else { 2*sin(x) }"), [0]);
        assert_eq!(depths("(if x < y { sin(x) } else { y }) + sin(x)"), [0]);
        assert_eq!(depths("if sin(x) < y { x } else { y }"), [0]);
        assert_eq!(depths("if x < y { if x < 1 { sin(x) } else { cos(y) } } else { y }"), [2, 2]);
        assert_eq!(depths("if x < y { if x < 1 { sin(x) } else { 2*sin(x) } } else { y }"), [1]);
    }
}
